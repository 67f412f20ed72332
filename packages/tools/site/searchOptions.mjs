/**
 * Options of the site's search.
 *
 * @satisfies {import('vitepress').DefaultTheme.LocalSearchOptions}
 */
export const searchOptions = {
  miniSearch: { searchOptions: { fuzzy: 0.1, prefix: true, boost: { title: 4, text: 2, titles: 1 } } },
};
