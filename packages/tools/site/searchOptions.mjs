/**
 * Options of the site's search. Beginnings of words weigh little, since names such as `lightLoopAll` begin like words.
 *
 * @satisfies {import('vitepress').DefaultTheme.LocalSearchOptions}
 */
export const searchOptions = {
  locales: {
    es: {
      translations: {
        button: { buttonText: 'Buscar', buttonAriaLabel: 'Buscar' },
        modal: {
          noResultsText: 'Nada encontrado para',
          resetButtonTitle: 'Borrar la búsqueda',
          footer: { selectText: 'elegir', navigateText: 'moverse', closeText: 'cerrar' },
        },
      },
    },
  },
  miniSearch: {
    options: {},
    searchOptions: {
      fuzzy: 0.1,
      prefix: true,
      weights: { fuzzy: 0.1, prefix: 0.1 },
      boost: { title: 4, text: 1, titles: 1.5 },
    },
  },
};
