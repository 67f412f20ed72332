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
    const { name, file, others } = example;
    const [title, sentence] = language === 'es' ? spanish.examples[name] : [example.title, example.sentence];
    const shown = [file, ...others].map((path) => {
      const code = readFileSync(join(galleryFolder, path), 'utf8');
      // title and sentence stand above
      const rest = path === file ? code.replace(/^\/\*\*[\s\S]*?\*\/\n/, '') : code;
      return `\`\`\`${path.split('.').at(-1)} [${path}]\n${rest}\`\`\``;
    });
    const code = shown.length === 1 ? shown[0] : `::: code-group\n\n${shown.join('\n\n')}\n\n:::`;
    return {
      params: { name, title },
      content: `# ${title}\n\n${sentence}\n\n<Example name="${name}" />\n\n${code}\n`,
    };
  });
}
