import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { galleryFolder, readExamples } from '@farol/tools/site/galleryExamples';

/** A page for each example of the gallery. */
export default {
  watch: ['../../live/gallery/*'],
  paths: () =>
    readExamples().map(({ name, title, sentence, file }) => {
      const code = readFileSync(join(galleryFolder, file), 'utf8').replace(/^\/\*\*[\s\S]*?\*\/\n/, '');
      const shown = `\`\`\`${file.split('.').at(-1)} [${file}]\n${code}\`\`\``;
      return {
        params: { name, title },
        content: `# ${title}\n\n${sentence}\n\n<Example name="${name}" />\n\n${shown}\n`,
      };
    }),
};
