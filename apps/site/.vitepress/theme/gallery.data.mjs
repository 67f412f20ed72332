import { readExamples, readFigures, readSizes } from '@farol/tools/site/galleryExamples';

/** The gallery's examples with their figures, and the bytes of what was built. */
export default {
  watch: ['../../live/gallery/*'],
  load() {
    const figures = readFigures();
    const sizes = readSizes();
    return readExamples().map(({ name, title, sentence, tags, editor }) => ({
      ...{ name, title, sentence, tags, editor },
      figures: figures[name] ?? null,
      size: sizes[name] ?? null,
    }));
  },
};
