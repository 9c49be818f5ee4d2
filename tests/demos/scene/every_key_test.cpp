// Every key of a scene has a true sentence: the defaults it names are those of the reader.

#include "demos/scene/every_key.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "demos/play/stage.h"
#include "demos/scene/catalog.h"
#include "demos/scene/explain.h"
#include "demos/scene/schema.h"
#include "demos/scene/toml_value.h"
#include "demos/text/stop.h"
#include "tests/demos/reading.h"

namespace demos::test {
namespace {

/// Calls `use` with every key, "*" for any.
template <class Use>
void forEveryKey(const Use& use) {
    for (const AskedTable& table : formatCatalog().tables()) {
        for (const AskedKey& key : table.keys) use(table, key.name, key.forms);
        if (!table.others.empty()) use(table, std::string("*"), table.others);
    }
}

TEST(EveryKey, HasASentence) {
    int keys = 0;
    forEveryKey([&](const AskedTable& table, const std::string& key, const auto& forms) {
        const std::string where = key + " in " + table.name;
        const KeyText* text = textOn(table.name, key);
        ASSERT_NE(text, nullptr) << where << ": give it in demos/scene/every_key_*.cpp";
        const std::string sentence = text->sentence;
        EXPECT_TRUE(sentence.ends_with('.')) << where;
        EXPECT_EQ(sentence.find(". "), std::string::npos) << where << " has more than one";
        EXPECT_GE(std::count(sentence.begin(), sentence.end(), ' '), 4) << where << " says little";
        EXPECT_NE(sentence, unitsOf(forms) + ".") << where;
        EXPECT_FALSE(text->usual.empty()) << where;
        ++keys;
    });
    EXPECT_GE(keys, 200);
}

TEST(EveryKey, HasASentenceOfItsOwn) {
    for (const TableTexts& texts : everyText()) {
        std::set<std::string> sentences, keys;
        for (const KeyText& text : texts.keys) {
            EXPECT_TRUE(sentences.insert(text.sentence).second) << texts.table << " " << text.key;
            EXPECT_TRUE(keys.insert(text.key).second) << texts.table << " " << text.key;
        }
    }
}

TEST(EveryKey, IsKnownToTheReader) {
    std::set<std::string> asked;
    forEveryKey([&](const AskedTable& table, const std::string& key, const auto&) {
        asked.insert(table.name + " " + key);
    });
    for (const TableTexts& texts : everyText())
        for (const KeyText& text : texts.keys)
            EXPECT_TRUE(asked.contains(std::string(texts.table) + " " + text.key))
                << texts.table << " " << text.key;
}

/// A scene's text again. The texts of the examples need no escapes.
std::string tomlOf(const Value& value) {
    std::string list;
    for (std::size_t i = 0; i < value.items.size(); ++i)
        list += (i > 0 ? ", " : "") + (value.keys.empty() ? "" : value.keys[i].name + " = ") +
                tomlOf(value.items[i]);
    switch (value.kind) {
        case Value::Kind::table:
            return "{ " + list + " }";
        case Value::Kind::array:
            return "[" + list + "]";
        case Value::Kind::text:
            return inToml(value.text);
        case Value::Kind::boolean:
            return inToml(value.boolean);
        default:
            return numberText(value.real);
    }
}

std::string fileOf(const Value& document) {
    std::string text;
    for (std::size_t i = 0; i < document.items.size(); ++i)
        text += document.keys[i].name + " = " + tomlOf(document.items[i]) + "\n";
    return text;
}

/// A table of an example: the way to it, as numbers of items.
struct Site {
    const Value* document;
    std::string table;
    std::vector<std::size_t> way;
};

Value& valueAt(Value& document, const std::vector<std::size_t>& way) {
    Value* value = &document;
    for (const std::size_t item : way) value = &value->items[item];
    return *value;
}

void findSites(const Value& value, const AskedTable& table, Site site, std::vector<Site>& all) {
    site.table = table.name;
    all.push_back(site);
    for (std::size_t i = 0; i < value.items.size(); ++i)
        for (const AskedKey& key : table.keys) {
            const AskedTable* held = formatCatalog().heldBy(key);
            if (key.name != value.keys[i].name || !held) continue;
            const Value& item = value.items[i];
            Site inner = site;
            inner.way.push_back(i);
            if (item.kind == Value::Kind::table) findSites(item, *held, inner, all);
            for (std::size_t k = 0; item.kind == Value::Kind::array && k < item.items.size(); ++k) {
                inner.way.push_back(k);
                if (item.items[k].kind == Value::Kind::table)
                    findSites(item.items[k], *held, inner, all);
                inner.way.pop_back();
            }
        }
}

/// The documents that can be read, and all their tables.
const std::vector<Site>& sites() {
    static std::vector<Value> documents;
    static const std::vector<Site> all = [] {
        for (const KeyExample& example : everyKey()) {
            Complaints complaints;
            if (!example.namesFiles) documents.push_back(parseToml(sceneOf(example), complaints));
        }
        std::vector<Site> found;
        for (const Value& document : documents)
            findSites(document, formatCatalog().tables().front(), {&document, "", {}}, found);
        return found;
    }();
    return all;
}

/// The scene's file with the key of one table left out, or with another value.
std::string changed(const Site& site, const std::string& key, const std::string* value) {
    Value document = *site.document;
    Value& table = valueAt(document, site.way);
    for (std::size_t i = 0; i < table.keys.size(); ++i) {
        if (table.keys[i].name != key) continue;
        if (value) {
            table.items[i] = parseTomlValue(*value, {1, 1});
        } else {
            table.items.erase(table.items.begin() + static_cast<std::ptrdiff_t>(i));
            table.keys.erase(table.keys.begin() + static_cast<std::ptrdiff_t>(i));
        }
        break;
    }
    return fileOf(document);
}

/// After a second of motion.
std::uint64_t hashOf(const std::string& file) {
    Stage stage(sceneFrom(file));
    for (int i = 0; i < 60; ++i) stage.step();
    return stage.world.hash();
}

bool isLiteral(const std::string& usual) {
    return usual == "true" || usual == "false" ||
           std::string("\"[-0123456789").find(usual[0]) != std::string::npos;
}

/// What the reader says of a scene without this key.
struct Without {
    bool refused = false, accepted = false;
};

Without leftOut(const char* table, const KeyText& text, const std::string& usual) {
    Without result;
    for (const Site& site : sites()) {
        Value document = *site.document;
        if (site.table != table || !valueAt(document, site.way).find(text.key)) continue;
        const std::string without = changed(site, text.key, nullptr);
        const bool fine = errorsOf(without).empty();
        (fine ? result.accepted : result.refused) = true;
        if (!fine || !isLiteral(usual)) continue;
        const std::string with = changed(site, text.key, &usual);
        const std::vector<std::string> errors = errorsOf(with);
        EXPECT_TRUE(errors.empty()) << table << " " << text.key << "\n" << listed(errors);
        if (!errors.empty()) continue;
        EXPECT_EQ(hashOf(with), hashOf(without)) << table << " " << text.key;
    }
    return result;
}

/// A key that is "required" cannot be left out somewhere; any other can, and moves nothing else
/// than its default does.
TEST(EveryKey, HasTheDefaultOfTheReader) {
    for (const TableTexts& texts : everyText())
        for (const KeyText& text : texts.keys) {
            if (text.key == std::string("*")) continue;
            const std::string usual = text.usual.substr(0, text.usual.find(';'));
            const Without without = leftOut(texts.table, text, usual);
            EXPECT_TRUE(usual.starts_with("required") ? without.refused : without.accepted)
                << texts.table << " " << text.key << ": " << text.usual;
        }
}

TEST(EveryKey, NamesTheDefaultsOfTheOtherPresets) {
    EXPECT_EQ(textOn("[solver]", "substeps")->usual, "4; preset fast: 2; preset seed: 1");
    EXPECT_EQ(textOn("[solver]", "order")->usual, "\"gravity\"; preset seed: \"pairs\"");
}

TEST(Explain, SaysWhatAKeyIs) {
    const std::string mass = explanationOf("body.mass");
    EXPECT_TRUE(mass.starts_with("body.mass: The mass, ")) << mass;
    for (const char* row : {"\n  type     a number\n", "\n  unit     kg\n",
                            "\n  default  density times volume\n", "\n  range    1e-06 to 1e+09\n"})
        EXPECT_NE(mass.find(row), std::string::npos) << row << mass;
    EXPECT_NE(explanationOf("joint.motor.speed").find("unit     m/s or rad/s"), std::string::npos);
}

TEST(Explain, TakesEveryKeyWithoutItsTable) {
    for (const KeyFacts& key : keyFacts()) {
        const std::string name = key.path.substr(key.path.rfind('.') + 1);
        if (name == "NAME") continue;  // any name of [values]
        const std::string said = "\n" + explanationOf(name);
        const bool ofTop = said.starts_with("\n" + name + ":");  // a table of this name comes first
        EXPECT_TRUE(ofTop || said.find("\n" + key.path + ": " + key.sentence) != std::string::npos)
            << key.path << said;
    }
    EXPECT_NE(explanationOf("turn_deg").find("\n\nbody.shape.turn_deg: "), std::string::npos);
    EXPECT_EQ(explanationOf("shape.turn_deg").find("\n\nbody.turn_deg"), std::string::npos);
}

TEST(Explain, TakesTheNameOrNumberOfAnItemAsSetDoes) {
    for (const char* path :
         {"body.box.mass", "body.3.mass", "body.\"a.b\".mass", "body[3].mass", "body.box[3].mass"})
        EXPECT_EQ(explanationOf(path), explanationOf("body.mass")) << path;
    EXPECT_EQ(explanationOf("values.radius"), explanationOf("values.NAME"));
}

TEST(Explain, ListsTheKeysOfATable) {
    const std::string solver = explanationOf("solver");
    long keys = 0;
    for (const TableTexts& texts : everyText())
        for (const KeyText& text : texts.keys) {
            if (texts.table != std::string("[solver]")) continue;
            EXPECT_NE(solver.find(std::string("\n  solver.") + text.key + " "), std::string::npos)
                << text.key;
            EXPECT_NE(solver.find(text.sentence), std::string::npos) << text.key;
            ++keys;
        }
    EXPECT_GE(keys, 15);
    EXPECT_EQ(std::count(solver.begin(), solver.end(), '\n'), keys + 4);
    EXPECT_NE(explanationOf("scene").find("\n  camera "), std::string::npos);
}

std::string refusalOf(const std::string& path) {
    try {
        return explanationOf(path);
    } catch (const Stop& stop) {
        return stop.what();
    }
}

TEST(Explain, NamesTheNearestKeysOfAWrongOne) {
    EXPECT_EQ(refusalOf("body.mas"),
              "no key of a scene is called 'body.mas'; did you mean 'body.mass'?");
    EXPECT_NE(refusalOf("solver.swee").find("did you mean 'solver.sweeps'?"), std::string::npos);
    EXPECT_NE(refusalOf("body.ball.spn").find("did you mean 'body.spin'?"), std::string::npos);
    EXPECT_NE(refusalOf("baumgart").find("did you mean 'solver.baumgarte'?"), std::string::npos);
    EXPECT_NE(refusalOf("bounciness").find("'material.restitution'"), std::string::npos);
    for (const char* path : {"", ".", "qqqqqqq", "solver.sweeps.x", "body.box", "values", "..[0]"})
        EXPECT_EQ(refusalOf(path).find('\n') == std::string::npos, path != std::string("values"))
            << refusalOf(path);
}

}  // namespace
}  // namespace demos::test
