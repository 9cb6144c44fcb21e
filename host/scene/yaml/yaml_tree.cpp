// See yaml_tree.h.
#include "scene/yaml/yaml_tree.h"

#include "base/error.h"
#include "base/spelling.h"
#include "scene/model/scene_limits.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <unordered_set>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

namespace hyalite {
namespace {

// Receives the parser's events and adds each finished value to the innermost open list or map.
class TreeBuilder : public YAML::EventHandler {
public:
    TreeBuilder(std::string file, bool hasLines) : file_(std::move(file)), hasLines_(hasLines) {}

    [[nodiscard]] YamlPointer root() const { return root_; }

    [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what, const std::string& hint = {}) const {
        const bool known = hasLines_ && !mark.is_null();
        throw Error(ExitCode::BadInput, SourceLocation{file_, known ? mark.line + 1 : 0, known ? mark.column + 1 : 0},
                    what, hint);
    }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (root_) {
            fail(mark, "a second document starts here", "a scene file holds one document");
        }
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        add(mark, begin(mark, YamlNode::Kind::Null, "?", anchor));
    }

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto found = anchors_.find(anchor);
        const auto isOpen = [&](const Open& open) { return open.node == found->second; };
        if (found == anchors_.end() || std::any_of(open_.begin(), open_.end(), isOpen)) {
            fail(mark, "this alias is inside the value it refers to");
        }
        add(mark, found->second);
    }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        const auto node = begin(mark, YamlNode::Kind::Scalar, tag, anchor);
        node->text = value;
        node->isQuoted = tag == "!"; // how the parser marks quotes
        add(mark, node);
    }

    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value /*style*/) override {
        open(mark, begin(mark, YamlNode::Kind::List, tag, anchor));
    }
    void OnSequenceEnd() override { close(); }

    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value /*style*/) override {
        open(mark, begin(mark, YamlNode::Kind::Map, tag, anchor));
    }
    void OnMapEnd() override { close(); }

private:
    struct Open {
        std::shared_ptr<YamlNode> node;
        YAML::Mark mark;
        bool hasKey = false; // map only: its last entry still lacks a value
        std::unordered_set<std::string> keys;
    };

    std::shared_ptr<YamlNode> begin(const YAML::Mark& mark, YamlNode::Kind kind, const std::string& tag,
                                    YAML::anchor_t anchor) {
        if (!tag.empty() && tag != "?" && tag != "!") {
            fail(mark, "unsupported YAML tag " + inQuotes(tag));
        }
        auto node = std::make_shared<YamlNode>();
        node->kind = kind;
        node->line = hasLines_ ? mark.line + 1 : 0;
        node->column = hasLines_ ? mark.column + 1 : 0;
        if (anchor != 0) {
            anchors_[anchor] = node;
        }
        return node;
    }

    void open(const YAML::Mark& mark, std::shared_ptr<YamlNode> node) {
        if (open_.size() >= kDeepestYaml) {
            failTooDeep(mark);
        }
        open_.push_back({std::move(node), mark, false, {}});
    }

    void close() {
        const Open finished = std::move(open_.back());
        open_.pop_back();
        add(finished.mark, finished.node);
    }

    // Adds a finished value to the innermost open list or map.
    void add(const YAML::Mark& mark, const std::shared_ptr<YamlNode>& node) {
        if (open_.empty()) {
            root_ = node;
            return;
        }
        Open& parent = open_.back();
        if (parent.node->kind == YamlNode::Kind::List) {
            parent.node->items.push_back(node);
        } else if (!parent.hasKey) {
            addKey(mark, parent, *node);
            return;
        } else {
            YamlEntry& entry = parent.node->entries.back();
            if (node->kind == YamlNode::Kind::Null) { // "key:" alone; the parser's mark is at the next token
                node->line = entry.line;
                node->column = entry.column;
            }
            entry.value = node;
            parent.hasKey = false;
        }
        parent.node->height = std::max(parent.node->height, node->height + 1);
        parent.node->size += node->size;
        if (open_.size() + node->height > kDeepestYaml + 1) {
            failTooDeep(mark);
        }
        if (parent.node->size > kMostYamlNodes) {
            fail(mark, "more than " + std::to_string(kMostYamlNodes) + " values",
                 "each alias counts as a copy of its value");
        }
    }

    void addKey(const YAML::Mark& mark, Open& map, const YamlNode& key) const {
        if (key.kind != YamlNode::Kind::Scalar) {
            fail(mark, "a key must be text");
        }
        if (!map.keys.insert(key.text).second) {
            const auto first = std::find_if(map.node->entries.begin(), map.node->entries.end(),
                                            [&](const YamlEntry& entry) { return entry.key == key.text; });
            fail(mark, "duplicate key " + inQuotes(key.text),
                 hasLines_ ? "first in line " + std::to_string(first->line) : std::string());
        }
        map.node->entries.push_back({key.text, key.line, key.column, nullptr});
        map.hasKey = true;
    }

    [[noreturn]] void failTooDeep(const YAML::Mark& mark) const {
        fail(mark, "lists and maps are nested more than " + std::to_string(kDeepestYaml) + " deep");
    }

    std::string file_;
    bool hasLines_;
    YamlPointer root_;
    std::vector<Open> open_;
    std::map<YAML::anchor_t, std::shared_ptr<YamlNode>> anchors_;
};

} // namespace

YamlPointer parseYaml(std::string_view text, const std::string& file, bool hasLines) {
    TreeBuilder builder(file, hasLines);
    try {
        std::istringstream stream{std::string(text)};
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder)) {
        }
    } catch (const YAML::Exception& error) {
        builder.fail(error.mark, "YAML: " + error.msg);
    }
    if (!builder.root()) {
        throw Error(ExitCode::BadInput, SourceLocation{file, 0, 0}, "contains no values");
    }
    return builder.root();
}

} // namespace hyalite
