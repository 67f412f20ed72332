import { readExamples, readFigures, readSizes } from '@farol/tools/site/galleryExamples';

/** Examples that the gallery begins with. */
const first = ['night-street', 'thousand-lights', 'campfire', 'first-lamp', 'water-surface', 'ten-thousand-lights'];

/** The gallery's examples with their figures, and the bytes of what was built. */
export default {
  watch: ['../../live/gallery/*'],
  load() {
    const figures = readFigures();
    const sizes = readSizes();
    const place = (/** @type {{ name: string }} */ { name }) =>
      first.includes(name) ? first.indexOf(name) : first.length;
    const examples = readExamples().toSorted((a, b) => place(a) - place(b));
    return examples.map(({ name, title, sentence, tags, editor }) => ({
      ...{ name, title, sentence, tags, editor },
      figures: figures[name] ?? null,
      size: sizes[name] ?? null,
    }));
  },
};
