import { basename, dirname } from 'node:path';
import { apiSections } from './api/apiPages.mjs';

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
    /** Sections of a page of the API, whose text is a script's; undefined of others: VitePress then reads the page. */
    _splitIntoSections: (/** @type {string} */ path) =>
      /** @type {ReturnType<typeof apiSections>} */ (
        basename(dirname(path)) === 'api' ? apiSections(basename(path, '.md')) : undefined
      ),
    options: {},
    searchOptions: {
      fuzzy: 0.1,
      prefix: true,
      weights: { fuzzy: 0.1, prefix: 0.1 },
      boost: { title: 4, text: 1, titles: 1.5 },
    },
  },
};
