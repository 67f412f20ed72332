import { AssetError } from '@farol/engine';
import { sourceFiles } from '@farol/tools/sourceFiles';
import { afterEach, expect, test, vi } from 'vitest';
import { ConsoleLog } from './model/ConsoleLog';
import { Notices } from './model/Notices';
import { ofEngine } from './language/es';
import { engine } from './language/es/engine';
import { messageTranslator } from './language/messageTable';
import { showLanguage } from './language/shownLanguage';

// restores English for other tests in the thread
afterEach(async () => {
  await showLanguage('en');
  vi.unstubAllGlobals();
});

afterEach(() => showLanguage('en'));

/** Replaces the parameters of a template in the sources, or of the table, by '{}'. */
const ofSource = (text: string): string => text.replaceAll(/\$\{[^{}]*\}/g, '{}').replaceAll(/\\(['"`])/g, '$1');
const ofTable = (text: string): string => text.replaceAll(/\{\w+\}/g, '{}');

test('the engine says each message of the table', () => {
  const sources = [...sourceFiles()]
    .filter(([path]) => path.startsWith('packages/engine/src/') && !/\.(test|bench)\.ts$/.test(path))
    .map(([, source]) => ofSource(source))
    .join('\n');
  const heads = ["The asset '{}' ", "The prefab '{}' ", 'The file ', 'format ', 'version '];
  const missing = Object.keys(engine).filter((english) => {
    const text = ofTable(english);
    const parts = [text, ...heads.filter((head) => text.startsWith(head)).map((head) => text.slice(head.length))];
    // the text of the last parameter may be defined in another source file
    return !parts.some((part) => sources.includes(part) || sources.includes(part.replace(/\{\}$/, '')));
  });
  expect(missing).toEqual([]);
});

test('its Spanish has the values of its English', () => {
  const names = (text: string): string => (text.match(/\{\w+\}/g) ?? []).toSorted().join();
  expect(Object.entries(engine).filter(([english, spanish]) => names(english) !== names(spanish))).toEqual([]);
});

test('a message within another, and one of two, are put into Spanish; what nobody knows stays', () => {
  const { message } = new AssetError('Props/robot.glb', 'could not be loaded: the file is empty: choose it again.');
  expect(ofEngine(message)).toBe(
    "No se pudo cargar el recurso 'Props/robot.glb': el archivo está vacío: hay que elegirlo de nuevo.",
  );
  expect(
    ofEngine(
      'Collider de Suelo: The Collider of Suelo has no size, since its object, or one above it, has a scale of 0: set another.',
    ),
  ).toBe(
    'Collider de Suelo: El Collider de Suelo no tiene tamaño: su objeto, o uno que lo contiene, tiene una escala de 0. Hay que poner otra.',
  );
  expect(
    ofEngine('Wave.ts, line 3: it exports no class: write `export default class … extends component({ … })`.'),
  ).toBe(
    'Wave.ts, line 3: no exporta ninguna clase: hay que escribir `export default class … extends component({ … })`.',
  );
  expect(ofEngine('x is not defined')).toBe('x is not defined');
  const odd = messageTranslator({ 'a {b} c': '{b}!' });
  expect(odd('a $& c; alpha a 1 c')).toBe('$&!; alpha 1!');
});

test('the console and the notices speak the language that is shown', async () => {
  const log = new ConsoleLog();
  const notices = new Notices(log);
  const message = "The asset 'a.png' is not in the library any more: choose another one.";
  notices.show('error', message);
  expect(log.entries[0].text).toBe(message);
  vi.stubGlobal('document', { documentElement: {} });
  await showLanguage('es');
  notices.show('error', message);
  expect(notices.current.at(-1)!.text).toBe("El recurso 'a.png' ya no existe: hay que elegir otro.");
  expect(log.entries.at(-1)!.text).toBe("El recurso 'a.png' ya no existe: hay que elegir otro.");
});
