import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { galleryFolder, readExamples, readSpanish } from './galleryExamples.mjs';

/**
 * A page for each example of the gallery: title, sentence, the example and its code.
 *
 * @param {'en' | 'es'} language
 */
export function galleryPages(language) {
  const spanish = readSpanish();
  return readExamples().map((example) => {
    const { name, file } = example;
    const [title, sentence] = language === 'es' ? spanish.examples[name] : [example.title, example.sentence];
    const code = readFileSync(join(galleryFolder, file), 'utf8').replace(/^\/\*\*[\s\S]*?\*\/\n/, '');
    const shown = `\`\`\`${file.split('.').at(-1)} [${file}]\n${code}\`\`\``;
    return {
      params: { name, title },
      content: `# ${title}\n\n${sentence}\n\n<Example name="${name}" />\n\n${shown}\n`,
    };
  });
}
