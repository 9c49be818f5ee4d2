/// Records which keys the reader asks for in which table: the source of the JSON Schema.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace demos {

struct Range {
    double low, high;
    const char* unit = "";
};

/// One kind of value that a key may have.
struct Form {
    enum class Kind {
        number,
        whole,
        truth,
        text,
        vector,   // [x, y, z]
        texts,    // one or a list
        numbers,  // a list
        vectors,  // a list of [x, y, z]
        word,
        color,
        table,
        tables  // one or a list
    };
    Kind kind = Kind::text;
    Range range{0.0, 0.0};                // of numbers
    std::vector<std::string> words = {};  // of a word
    std::string table = {};  // name of the table or tables; empty: that of the key
    std::string units = {};  // of all its ranges: "m/s or rad/s"
};

/// The units of all forms: "m/s or rad/s"; empty if there is none.
std::string unitsOf(const std::vector<Form>& forms);

struct AskedKey {
    std::string name;
    std::vector<Form> forms;  // each kind once
    bool given = false;       // at least one scene that was read has it
};

struct AskedTable {
    std::string name;  // as in messages: "[world]", "a [[body]]"
    std::vector<AskedKey> keys;
    std::vector<Form> others;  // forms of any other key: [values]
};

/// "a key of the camera" -> "key-of-the-camera", "an [[expect]]" -> "expect"
std::string definitionName(std::string_view table);

class Catalog {
public:
    AskedKey& ask(const std::string& table, std::string_view key, bool given);
    /// A form of a known kind is merged: the union of both ranges and of both word lists.
    void ask(const std::string& table, std::string_view key, const Form& form, bool given);
    void askOthers(const std::string& table, const Form& form);

    /// In the order in which they were first asked; the first is the file itself.
    const std::vector<AskedTable>& tables() const { return tables_; }
    /// The table that a key holds, alone or in a list; null if it holds none.
    const AskedTable* heldBy(const AskedKey& key) const;

private:
    AskedTable& tableOf(const std::string& name);

    std::vector<AskedTable> tables_;
};

}  // namespace demos
