//! Just enough of a Rust reader to answer one question: which paths does a source file name?

/// The paths of a source, in imports and expressions alike, with `use` trees expanded: `crate::{a, b::c}` is two paths.
/// Comments and text literals do not count.
pub fn paths(source: &str) -> Vec<Vec<String>> {
    let tokens = tokens(&code_only(source));
    let mut found = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        at = if is_name(&tokens[at]) { read_tree(&tokens, at, &[], &mut found) } else { at + 1 };
    }
    found
}

/// Reads the path or `use` tree that starts at `at`, records each full path, returns where it ends.
fn read_tree(tokens: &[String], mut at: usize, prefix: &[String], found: &mut Vec<Vec<String>>) -> usize {
    let token = |at: usize| tokens.get(at).map_or("", String::as_str);
    let mut path = prefix.to_vec();
    while is_name(token(at)) || token(at) == "*" {
        path.push(token(at).to_owned());
        if token(at + 1) != "::" {
            found.push(path);
            return at + 1;
        }
        at += 2;
    }
    if token(at) != "{" {
        found.push(path);
        return at + 1;
    }
    at += 1;
    while at < tokens.len() && token(at) != "}" {
        at = read_tree(tokens, at, &path, found);
        while at < tokens.len() && token(at) != "," && token(at) != "}" {
            at += 1;
        }
        at += usize::from(token(at) == ",");
    }
    at + 1
}

fn is_name(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// Words, `::`, and every other visible character by itself.
fn tokens(code: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    let mut rest = code.trim_start();
    while let Some(first) = rest.chars().next() {
        let word = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        let length = match word {
            0 if rest.starts_with("::") => 2,
            0 => first.len_utf8(),
            _ => word,
        };
        tokens.push(rest[..length].to_owned());
        rest = rest[length..].trim_start();
    }
    tokens
}

/// The source without comments, texts and character literals; each leaves a space.
fn code_only(source: &str) -> String {
    let mut code = String::new();
    let mut rest = source;
    while let Some(first) = rest.chars().next() {
        let skipped = comment(rest).or_else(|| text(rest, &code)).or_else(|| character(rest));
        match skipped {
            Some(_) => code.push(' '),
            None => code.push(first),
        }
        rest = &rest[skipped.unwrap_or(first.len_utf8())..];
    }
    code
}

/// The length of the comment that starts here.
fn comment(rest: &str) -> Option<usize> {
    if rest.starts_with("//") {
        return Some(rest.find('\n').unwrap_or(rest.len()));
    }
    let mut depth = 0;
    let mut at = 0;
    while rest.starts_with("/*") && at < rest.len() {
        let here = &rest.as_bytes()[at..];
        let step = if here.starts_with(b"/*") || here.starts_with(b"*/") { 2 } else { 1 };
        depth += i32::from(here.starts_with(b"/*")) - i32::from(here.starts_with(b"*/"));
        at += step;
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

/// The length of the text literal that starts here, raw ones included; `before` is the code read so far.
fn text(rest: &str, before: &str) -> Option<usize> {
    let hashes = rest.bytes().take_while(|&byte| byte == b'#').count();
    if before.ends_with('r') && rest[hashes..].starts_with('"') {
        let end = format!("\"{}", "#".repeat(hashes));
        let body = hashes + 1;
        return Some(rest[body..].find(&end).map_or(rest.len(), |length| body + length + end.len()));
    }
    rest.starts_with('"').then(|| closing(rest, '"'))
}

/// The length of the character literal that starts here; a lifetime is none.
fn character(rest: &str) -> Option<usize> {
    let mut characters = rest.strip_prefix('\'')?.chars();
    let (first, second) = (characters.next()?, characters.next()?);
    (first == '\\' || second == '\'').then(|| closing(rest, '\''))
}

/// The length up to and with the closing quote that no backslash escapes.
fn closing(rest: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, character) in rest.char_indices().skip(1) {
        if character == quote && !escaped {
            return at + quote.len_utf8();
        }
        escaped = character == '\\' && !escaped;
    }
    rest.len()
}

#[cfg(test)]
mod tests {
    use super::paths;

    fn joined(source: &str) -> Vec<String> {
        paths(source).iter().filter(|path| path.len() > 1).map(|path| path.join("::")).collect()
    }

    #[test]
    fn trees_are_expanded() {
        let source = "pub use crate::{math::{self, pose::Pose as P}, model::*,}; let x = super::super::a::b::<f64>(1);";
        let expected =
            ["crate::math::self", "crate::math::pose::Pose", "crate::model::*", "super::super::a::b"];
        assert_eq!(joined(source), expected);
    }

    #[test]
    fn comments_and_texts_are_not_code() {
        let source = r##"
            // crate::a::b
            /* crate::c /* crate::d */ crate::e */
            //! [`crate::f`]
            let t = "crate::g \" crate::h"; let r = r#"crate::i " crate::j"#; let b = b"crate::k";
            let quote = '"'; let escape = '\''; fn f<'a>(x: &'a crate::l::M) {}
        "##;
        assert_eq!(joined(source), ["crate::l::M"]);
    }
}
