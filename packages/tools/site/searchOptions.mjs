import { apiSections } from './api/apiPages.mjs';
import { gallerySections } from './galleryPages.mjs';

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
    /** Sections of a page whose text is a script's; undefined of others: VitePress then reads the page. */
    _splitIntoSections(/** @type {string} */ path) {
      const [file, folder, above] = path.split(/[\\/]/).toReversed();
      const name = file.replace('.md', '');
      if (folder === 'api') return apiSections(name);
      return /** @type {ReturnType<typeof apiSections>} */ (
        folder === 'gallery' ? gallerySections(above === 'es' ? 'es' : 'en', name) : undefined
      );
    },
    options: {},
    searchOptions: {
      fuzzy: 0.1,
      prefix: true,
      weights: { fuzzy: 0.1, prefix: 0.1 },
      boost: { title: 4, text: 1, titles: 1.5 },
    },
  },
};
