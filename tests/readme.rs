//! The README shows an example as it is; rustdoc runs it there.

#[test]
fn the_readme_shows_the_example_as_it_is() {
    let read =
        |file: &str| std::fs::read_to_string(format!("{}/{file}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let source = read("crate/examples/track_a_body.rs");
    let (title, program) = source.split_once("\n\n").unwrap();
    assert!(title.starts_with("//! ") && program.starts_with("use rangelab::"));
    assert!(
        read("README.md").contains(&format!("```rust\n{program}```\n")),
        "the README shows another program"
    );
}
