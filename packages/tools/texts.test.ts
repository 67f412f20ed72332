import { expect, test } from 'vitest';
import { propertyTexts, textsOf } from './texts.mjs';

const faults = (source: string): string[] => textsOf('x.tsx', source).faults;

test('texts are found where they are given to t and tCount', () => {
  const source = `
    const f = (count: number, name: string) => [
      t('Add {name}', { name }), t(count > 1 ? 'Many' : \`One\`), tCount(count, '{count} light', '{count} lights'), t(name),
    ];`;
  expect(textsOf('x.ts', source)).toEqual({
    texts: ['Add {name}', 'Many', 'One', '{count} light', '{count} lights'],
    faults: [],
  });
  expect(
    propertyTexts('x.ts', "const a = { help: 'Bends.', label: x ? 'Bend' : 'Turn', y: 'z' };", 'help', 'label'),
  ).toEqual(['Bends.', 'Bend', 'Turn']);
});

test.each([
  ["const label = t('Add');", /'Add' is looked up before there is a language/],
  ['const a = () => <p>Some words</p>;', /'Some words' is shown without t/],
  ['const a = () => <p title="Some words" />;', /'Some words' is shown without t/],
  ["const a = () => <p aria-label={b ? t('x') : 'Words'} />;", /'Words' is shown without t/],
  ['const a = () => <p>{b && `${c} lights`}</p>;', /'lights' is shown without t/],
  ["const a = () => countLabel('Delete', objects);", /'Delete' is shown without t/],
])('%s is a fault', (source, why) => {
  expect(faults(source)).toHaveLength(1);
  expect(faults(source)[0]).toMatch(why);
});

test('names, units, and what nobody reads are no faults', () => {
  expect(faults('const a = () => <p className="dark red" id={`x-${y}`}>Farol {n} ms · {t("Words")}</p>;')).toEqual([]);
  expect(faults("class A { label = t('Words'); }")).toEqual([]);
});
