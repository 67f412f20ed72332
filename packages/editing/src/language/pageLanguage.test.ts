import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { showPageLanguage, startPageLanguage } from './pageLanguage';
import { setTexts, t, textLanguage } from './translate';

const spanish = async () => ({ Lights: 'Luces' });
let kept: Map<string, string>;
const page = { documentElement: { lang: 'en' } };

beforeEach(() => {
  kept = new Map();
  page.documentElement.lang = 'en';
  vi.stubGlobal('document', page);
  vi.stubGlobal('navigator', { languages: ['es-MX', 'en'] });
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => void kept.set(key, value),
  });
});
afterEach(() => {
  setTexts({});
  vi.unstubAllGlobals();
});

test('a page opens in the browser’s language, and the next time in the one that was chosen', async () => {
  expect(await startPageLanguage(spanish)).toBe('es');
  expect([t('Lights'), t('Sphere'), page.documentElement.lang]).toEqual(['Luces', 'Sphere', 'es']);
  expect(kept.size).toBe(0);

  expect(await showPageLanguage('en', spanish)).toBe(true);
  expect([t('Lights'), page.documentElement.lang]).toEqual(['Lights', 'en']);
  expect(await startPageLanguage(spanish)).toBe('en');
});

test('of two choices the later one counts, whichever texts come first', async () => {
  let arrive = (_texts: Record<string, string>): void => {};
  const late = new Promise<Record<string, string>>((resolve) => (arrive = resolve));
  const first = showPageLanguage('es', () => late);
  await showPageLanguage('en', spanish);
  arrive({ Lights: 'Luces' });
  expect(await first).toBe(false);
  expect([t('Lights'), textLanguage()]).toEqual(['Lights', 'en']);
});

test('a page whose texts cannot be fetched, or without storage, opens in English', async () => {
  expect(await startPageLanguage(() => Promise.reject(new Error('no server')))).toBe('en');
  vi.stubGlobal('localStorage', undefined);
  vi.stubGlobal('navigator', { languages: [] });
  expect(await startPageLanguage(spanish)).toBe('en');
  expect(await showPageLanguage('es', spanish)).toBe(true);
});
