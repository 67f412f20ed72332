import { readExamples, readFigures, readSizes, readSpanish } from '@farol/tools/site/galleryExamples';

/** Examples that the gallery begins with. */
const first = ['night-street', 'thousand-lights', 'campfire', 'first-lamp', 'water-surface', 'ten-thousand-lights'];

/** The gallery's examples with their figures and the sizes of their built scripts (bytes). */
export default {
  watch: ['../../live/gallery/*'],
  load() {
    const figures = readFigures();
    const sizes = readSizes();
    const spanish = readSpanish();
    const place = (/** @type {{ name: string }} */ { name }) =>
      first.includes(name) ? first.indexOf(name) : first.length;
    const examples = readExamples().toSorted((a, b) => place(a) - place(b));
    return examples.map(({ name, title, sentence, tags, editor }) => ({
      ...{ name, tags, editor },
      en: { title, sentence, tags },
      es: {
        title: spanish.examples[name][0],
        sentence: spanish.examples[name][1],
        tags: tags.map((tag) => spanish.tags[tag]),
      },
      figures: figures[name] ?? null,
      size: sizes[name] ?? null,
    }));
  },
};
