import { useData, withBase } from 'vitepress';
import { computed } from 'vue';

/** Words of the gallery, English and Spanish. */
const words = {
  en: {
    search: 'Search examples',
    of: 'of',
    tags: 'Tags',
    agreement: "Agreement with stock three's picture",
    bytes: "Scripts, gzipped, beside three's own",
    nothing: 'Nothing has these words and this tag.',
    compared: 'Agreement with stock three',
    by: 'by',
    without: ', without what stock three has not or cannot draw: ',
    scripts: 'Scripts before the first frame, gzipped',
    ofThree: "of three's",
    withThree: "with three's",
    and: 'and',
    editor: 'In the editor',
    openEditor: 'Open it in the editor',
    howEditor: 'npm start, then at the end of its address',
    others: 'Other examples',
    full: 'Full page',
    all: 'All examples',
  },
  es: {
    search: 'Buscar ejemplos',
    of: 'de',
    tags: 'Etiquetas',
    agreement: 'Coincidencia con la imagen de three',
    bytes: 'Scripts comprimidos, además de los de three',
    nothing: 'Nada tiene estas palabras y esta etiqueta.',
    compared: 'Coincidencia con three',
    by: 'con',
    without: ', sin lo que three no tiene o no puede dibujar: ',
    scripts: 'Scripts antes del primer fotograma, comprimidos',
    ofThree: 'de three',
    withThree: 'con los de three',
    and: 'y',
    editor: 'En el editor',
    openEditor: 'Abrir en el editor',
    howEditor: 'npm start, y al final de su dirección',
    others: 'Otros ejemplos',
    full: 'Página completa',
    all: 'Todos los ejemplos',
  },
};

/** Language of the page, its words, and addresses of the gallery's pages in it. */
export function useGalleryTexts() {
  const { lang } = useData();
  const language = computed(() => (lang.value.startsWith('es') ? 'es' : 'en'));
  const address = (/** @type {string} */ page) => withBase(`${language.value === 'es' ? '/es' : ''}/gallery/${page}`);
  return { language, words: computed(() => words[language.value]), address };
}
