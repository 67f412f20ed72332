import { expect, test } from 'vitest';
import { scriptElement } from './exportHtml';

const texts = [
  '</script>',
  '</SCRIPT ><meta http-equiv=refresh>',
  '</ScRiPt/>',
  '<!-- <script>',
  '<!--<SCRIPT></script',
];

test.each(texts)('%s in a literal of a script keeps its value, and does not end the element', (text) => {
  const code = `[${JSON.stringify(text)}, \`${text}\`, /${text.replaceAll('/', '\\/')}/u.test(${JSON.stringify(text)})]`;
  const element = scriptElement('n', code);
  const inside = /^<script nonce="n">(.*)<\/script>$/s.exec(element)![1];
  expect(inside).not.toMatch(/<\/script|<!--/i);
  expect(new Function(`return ${inside}`)()).toEqual([text, text, true]);
});
