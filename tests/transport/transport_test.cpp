// The third opinion: what integrators on both sides show, against paper.
#include "transport/table.h"

#include <catch2/catch_test_macros.hpp>

namespace hyalite::testing {

TEST_CASE("a point of a surface has the radiance that formulas give it, by lights of every kind") {
    const std::vector<Row> rows = directLightRows();
    FalseAlarms alarms(comparisons(rows));
    checkRows(alarms, rows);
}

TEST_CASE("all the flux of a light arrives, straight and by way of mirrors and glass") {
    const std::vector<Row> rows = fluxRows();
    FalseAlarms alarms(comparisons(rows));
    checkRows(alarms, rows);
}

TEST_CASE("faces reflect as Fresnel says") {
    const std::vector<Row> rows = faceRows();
    FalseAlarms alarms(comparisons(rows));
    checkRows(alarms, rows);
}

TEST_CASE("slabs and stacks of slabs reflect and transmit as the adding method says") {
    const std::vector<Row> rows = slabRows();
    FalseAlarms alarms(comparisons(rows));
    checkRows(alarms, rows);
}

TEST_CASE("solids of every kind that absorb nothing are invisible in a furnace") {
    const std::vector<Row> rows = furnaceRows();
    FalseAlarms alarms(comparisons(rows));
    checkRows(alarms, rows);
}

TEST_CASE("a scene looks the same wherever it stands, turned, and in any unit of length") {
    const std::vector<Symmetry> symmetries = placementSymmetries();
    FalseAlarms alarms(comparisons(symmetries));
    checkSymmetries(alarms, symmetries);
}

TEST_CASE("light adds up, and goes both ways") {
    const std::vector<Symmetry> symmetries = lightSymmetries();
    FalseAlarms alarms(comparisons(symmetries));
    checkSymmetries(alarms, symmetries);
}

TEST_CASE("a surface looks the same however it is described") {
    const std::vector<Symmetry> symmetries = shapeSymmetries();
    FalseAlarms alarms(comparisons(symmetries));
    checkSymmetries(alarms, symmetries);
}

TEST_CASE("media lie in media") {
    const std::vector<Row> rows = mediaRows();
    FalseAlarms alarms(comparisons(rows));
    checkRows(alarms, rows);
}

TEST_CASE("scenes out of proportion have the radiance that they have in proportion") {
    const std::vector<Row> rows = proportionRows();
    FalseAlarms alarms(comparisons(rows));
    checkRows(alarms, rows);
}

TEST_CASE("a scene looks the same far from the origin, and a solid from afar") {
    const std::vector<Symmetry> symmetries = farSymmetries();
    FalseAlarms alarms(comparisons(symmetries));
    checkSymmetries(alarms, symmetries);
}

TEST_CASE("light outside a closed room changes nothing in it") {
    const std::vector<Symmetry> symmetries = outsideSymmetries();
    FalseAlarms alarms(comparisons(symmetries));
    checkSymmetries(alarms, symmetries);
}

} // namespace hyalite::testing
