//! The map in the README: a fenced tree under the heading "Map", two spaces a level, folders with a closing slash,
//! each name followed by what it is for.

/// The paths that the map names, folders with their closing slash; `None` where there is no map.
pub fn named_paths(readme: &str) -> Option<Vec<String>> {
    let section = readme.split_once("\n## Map\n")?.1;
    let tree = section.split("```").nth(1)?;
    let mut folders: Vec<&str> = Vec::new();
    let mut paths = Vec::new();
    for line in tree.lines().skip(1).filter(|line| !line.trim().is_empty()) {
        let name = line.split_whitespace().next()?;
        let level = (line.len() - line.trim_start().len()) / 2;
        folders.truncate(level);
        paths.push(format!("{}{name}", folders.concat()));
        folders.push(name);
    }
    Some(paths)
}

/// Where map and disk differ, one sentence each. `files` are the repository's, from its root.
pub fn differences(readme: &str, files: &[String]) -> Vec<String> {
    let Some(named) = named_paths(readme) else {
        return vec!["README.md has no fenced tree under the heading Map".to_owned()];
    };
    let on_disk = |path: &String| {
        files.iter().any(|file| file == path || path.ends_with('/') && file.starts_with(path))
    };
    let gone = named
        .iter()
        .filter(|path| !on_disk(path))
        .map(|path| format!("the map names {path}, which is not there"));
    let mut folders: Vec<String> = files.iter().filter_map(|file| mapped_folder(file)).collect();
    folders.sort();
    folders.dedup();
    let missing = folders.iter().filter(|folder| !named.contains(folder));
    gone.chain(missing.map(|folder| format!("{folder} is not on the map"))).collect()
}

/// The folder of a file that has to be on the map: at the top, or one below in crate/ and web/.
fn mapped_folder(file: &str) -> Option<String> {
    let depth = if file.starts_with("crate/") || file.starts_with("web/") { 2 } else { 1 };
    let folders: Vec<&str> =
        file.split_inclusive('/').filter(|part| part.ends_with('/')).take(depth).collect();
    if folders.is_empty() { None } else { Some(folders.concat()) }
}
