import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { galleryFolder, readExamples, readSpanish } from './galleryExamples.mjs';

/**
 * Section of an example's page for the site's search, which reads no generated page by itself: its title is given as a
 * parent title, as in apiSections, so that guides with the same words rank higher.
 *
 * @param {'en' | 'es'} language
 * @param {string} name - of the page's file, without ending
 * @returns {{ anchor: string, titles: string[], text: string }[] | undefined} undefined of a page that is no example's
 */
export function gallerySections(language, name) {
  const example = readExamples().find((each) => each.name === name);
  if (!example) return undefined;
  const spanish = language === 'es' ? readSpanish() : null;
  const [title, sentence] = spanish?.examples[name] ?? [example.title, example.sentence];
  const tags = example.tags.map((tag) => spanish?.tags[tag] ?? tag);
  return [{ anchor: '', titles: [title, spanish ? 'Ejemplo' : 'Example'], text: `${sentence} ${tags.join(' ')}` }];
}

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
      // without the docblock: the page shows its title and sentence above the code
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
