/// What the reader asks of which table, written down while it reads: the source of the JSON Schema.
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
    std::string table = {};  // what the table or tables are called; empty: as the key is
};

struct AskedKey {
    std::string name;
    std::vector<Form> forms;  // each kind once
    bool given = false;       // some scene that was read had it
};

struct AskedTable {
    std::string name;  // as in complaints: "[world]", "a [[body]]"
    std::vector<AskedKey> keys;
    std::vector<Form> others;  // what any other key may be: [values]
};

class Catalog {
public:
    AskedKey& ask(const std::string& table, std::string_view key, bool given);
    /// Of the same kind as before: the wider of both ranges, the words of both.
    void ask(const std::string& table, std::string_view key, const Form& form, bool given);
    void askOthers(const std::string& table, const Form& form);

    /// In the order in which they were first asked.
    const std::vector<AskedTable>& tables() const { return tables_; }

private:
    AskedTable& tableOf(const std::string& name);

    std::vector<AskedTable> tables_;
};

}  // namespace demos
