import { repository } from '../sitePages.mjs';
import { readExamples } from './examples.mjs';
import { readApi } from './readApi.mjs';

/** @typedef {import('./readApi.mjs').ApiExport} ApiExport */
/** @typedef {import('./examples.mjs').Example} Example */

/**
 * A page of the API: an entry of a package, or a folder of one that has many exports.
 *
 * @typedef {object} ApiPage
 * @property {string} name - of its file, without ending
 * @property {string} title
 * @property {string} entry - as pages import it
 * @property {ApiExport[]} exports - by kind, then in alphabetical order
 * @property {ApiExport[]} elsewhere - exports of the entry that another page shows
 */

/** Exports from which on an entry has a page for each folder. */
const MANY = 60;
/** Exports of a folder that are worth a page. */
const FEW = 6;

/** Kinds of exports, as a page shows them. @type {ApiExport['kind'][]} */
const order = ['class', 'function', 'constant', 'interface', 'type'];

/** @type {{ pages: ApiPage[], examples: Map<ApiExport, Example> } | undefined} */
let read;

/** Pages of the API, in the order of packages and entries, and an example of each export; read once. */
export function apiPages() {
  if (read) return read;
  const api = readApi();
  /** @type {Map<string, ApiPage>} */
  const pages = new Map();
  const sizes = countBy(api, ({ entries }) => entries[0]);
  const folders = countBy(api, folderKey);
  for (const each of api) {
    const [entry] = each.entries;
    const folder = folderKey(each).slice(entry.length + 1);
    const isSplit = (sizes.get(entry) ?? 0) >= MANY;
    const part = !isSplit ? '' : (folders.get(folderKey(each)) ?? 0) >= FEW ? folder : 'others';
    const base = entry.replace('@farol/', '').replaceAll('/', '-');
    const name = part ? `${base}_${part}` : base;
    const page = pages.get(name) ?? {
      name,
      title: part ? `${entry}: ${part}` : entry,
      entry,
      exports: [],
      elsewhere: [],
    };
    page.exports.push(each);
    pages.set(name, page);
  }
  for (const page of pages.values()) {
    page.exports.sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind) || a.name.localeCompare(b.name));
    page.elsewhere = api.filter(({ entries }) => entries.slice(1).includes(page.entry));
  }
  return (read = { pages: [...pages.values()], examples: readExamples(api) });
}

/** Entry and folder in the package's sources. @param {ApiExport} each */
const folderKey = ({ entries: [entry], file }) => `${entry} ${file.split('/').slice(3, -1)[0] ?? 'others'}`;

/** @template T @param {T[]} list @param {(each: T) => string} key */
function countBy(list, key) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (const each of list) counts.set(key(each), (counts.get(key(each)) ?? 0) + 1);
  return counts;
}

/**
 * Sidebar of the API's pages.
 *
 * @returns {{ text: string, items: { text: string, link: string }[] }[]} a group of each package
 */
export function apiBar() {
  /** @type {Map<string, ReturnType<typeof apiBar>[number]>} */
  const groups = new Map([['', { text: 'API', items: [{ text: 'All exports', link: '/api/' }] }]]);
  for (const { name, title, entry } of apiPages().pages) {
    const text = entry.split('/').slice(0, 2).join('/');
    const group = groups.get(text) ?? { text, items: [] };
    group.items.push({ text: title.slice(text.length).replace(/^: /, '') || entry, link: `/api/${name}` });
    groups.set(text, group);
  }
  return [...groups.values()];
}

/**
 * Sections of an API page for the site's search: names alone, as parent titles, which weigh less than a section's own.
 *
 * @param {string} name - of the page's file, without ending
 * @returns {{ anchor: string, titles: string[], text: string }[]}
 */
export function apiSections(name) {
  const page = apiPages().pages.find((each) => each.name === name);
  return (page?.exports ?? []).map((each) => ({
    anchor: each.name,
    titles: [each.name, page?.title ?? ''],
    text: [each.doc.text.split(/\n\n|(?<=\.)\s/)[0], ...each.members.map((member) => member.name)].join(' '),
  }));
}

/** Markdown of the page that lists all exports. */
export function apiIndex() {
  const lists = apiPages().pages.map(({ name, title, exports }) => {
    const names = exports.map((each) => `[\`${each.name}\`](./${name}.md#${each.name})`).join(' · ');
    return `## [${title}](./${name}.md)\n\n${names}`;
  });
  return `# API

Every export of every entry, from the sources' docblocks. Units are SI, angles radians, colours linear, unless a text says otherwise. Examples are parts of files that the tests compile and run.

${lists.join('\n\n')}
`;
}

/** Markdown of a page. @param {ApiPage} page */
export function apiPage(page) {
  const writer = new Writer(page);
  const { entry, title, exports, elsewhere } = page;
  const also = elsewhere.map(({ name }) => writer.link(name)).join(', ');
  return [
    `# ${title}`,
    `\`import { … } from '${entry}'\``,
    ...(also ? [`Shown on other pages: ${also}.`] : []),
    ...exports.map((each) => writer.export(each)),
    '',
  ].join('\n\n');
}

class Writer {
  /** Page and anchor of each export, by name. @type {Map<string, string>} */
  places = new Map();

  /** @param {ApiPage} page */
  constructor(page) {
    // of exports that share a name, those of the page come first
    for (const each of [
      ...apiPages()
        .pages.filter((each) => each !== page)
        .toReversed(),
      page,
    ])
      for (const { name } of each.exports) this.places.set(name, `./${each.name}.md#${name}`);
  }

  /** @param {ApiExport} each */
  export(each) {
    const { name, kind, signatures, doc, members, file, line, entries, types } = each;
    const source = `[source](${repository}/blob/main/${file}#L${line})`;
    const [made, listed] = [true, false].map((is) =>
      members.filter((member) => is === (member.name === 'constructor')),
    );
    const code = [...signatures, ...made.map((member) => member.signature.replace(/^constructor/, `new ${name}`))];
    const also = entries.slice(1).map((entry) => `\`${entry}\``);
    return [
      `## ${name} {#${name}}`,
      `${kind} · ${source}${also.length > 0 ? ` · also from ${also.join(', ')}` : ''}`,
      `\`\`\`ts\n${code.join('\n')}\n\`\`\``,
      this.text(doc.text),
      ...made.map((member) => this.text(member.doc.text)),
      this.named('Parameters', [...doc.params, ...made.flatMap((member) => member.doc.params)]),
      this.titled('Returns', doc.returns),
      this.titled('Throws', [...doc.throws, ...made.flatMap((member) => member.doc.throws)]),
      this.titled('See', doc.see),
      listed.length > 0 ? `**Members**\n\n${this.list(listed.map((member) => this.member(member)))}` : '',
      types.length > 0 ? `Types: ${types.map((type) => this.link(type.name)).join(', ')}` : '',
      this.example(each),
    ]
      .filter(Boolean)
      .join('\n\n');
  }

  /** @param {import('./declarations.mjs').ApiMember} member */
  member({ signature, doc }) {
    const more = [
      ...doc.params.map(({ name, text }) => `\`${name}\`: ${text}`),
      ...doc.returns.map((text) => `Returns ${text}`),
      ...doc.throws.map((text) => `Throws ${text}`),
    ].map((text) => (/[.:;]$/.test(text) ? text : `${text}.`));
    return [
      `\`${signature.replaceAll('`', "'")}\``,
      ...[doc.text, ...more].filter(Boolean).map((text) => this.text(text)),
    ].join('<br>');
  }

  /** @param {ApiExport} each */
  example(each) {
    const example = apiPages().examples.get(each);
    if (!example) return '';
    const file = `[${example.path}](${repository}/blob/main/${example.path}#L${example.line})`;
    const gallery = /^apps\/site\/live\/gallery\/(.*)\.tsx?$/.exec(example.path)?.[1];
    const seen = gallery ? `, [running in the gallery](../gallery/${gallery}.md)` : '';
    const other = example.of === each.name ? '' : ` of ${this.link(example.of)}`;
    return `**Example**${other}, from ${file}${seen}\n\n\`\`\`${example.language}\n${example.code}\n\`\`\``;
  }

  /** @param {string} title @param {string[]} texts */
  titled(title, texts) {
    if (texts.length === 0) return '';
    return texts.length === 1
      ? `**${title}** ${this.text(texts[0])}`
      : `**${title}**\n\n${this.list(texts.map((text) => this.text(text)))}`;
  }

  /** @param {string} title @param {{ name: string, text: string }[]} params */
  named(title, params) {
    if (params.length === 0) return '';
    return `**${title}**\n\n${this.list(params.map(({ name, text }) => `\`${name}\`: ${this.text(text)}`))}`;
  }

  /** @param {string[]} items */
  list(items) {
    return items.map((item) => `- ${item.replaceAll('\n', '\n  ')}`).join('\n');
  }

  /** Text of a docblock as Markdown of a page: links to exports, no HTML, no expressions of Vue's. @param {string} text */
  text(text) {
    return text
      .replace(/\{@link ([\w.]+)(?:\s*\|\s*([^}]*))?\}/g, (_all, name, shown) => this.link(name, shown))
      .split(/(`[^`]*`)/)
      .map((part, i) => (i % 2 === 1 ? part : part.replaceAll('<', '&lt;').replaceAll('{{', '&#123;&#123;')))
      .join('');
  }

  /** @param {string} name - of an export, or of its member @param {string} [shown] */
  link(name, shown = `\`${name}\``) {
    const place = this.places.get(name.split('.')[0]);
    return place ? `[${shown}](${place})` : shown;
  }
}
