import { AssetLibrary, Scene } from '@farol/engine';
import { readSceneFile } from '@farol/engine/files';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { exportHtml } from './exportHtml';
import { decodeLink } from './linkText';
import { linkHash } from './shareLink';

const asked: string[] = [];

beforeEach(() => {
  asked.length = 0;
  vi.stubGlobal('document', { baseURI: 'https://farol.example/' });
  vi.stubGlobal('fetch', (url: URL) => {
    asked.push(url.pathname);
    return Promise.resolve(new Response('player()'));
  });
});
afterEach(() => vi.unstubAllGlobals());

/** A scene with a script that is not run, and a component of it kept as data. */
function scriptedScene(): Scene {
  const assets = new AssetLibrary();
  assets.addFieldAsset('script', 'Spy', {
    source: `import { component } from '@farol/engine/fields';\nexport default class Spy extends component({ marker: 1 }) {}`,
  });
  return new Scene({ assets });
}

/** JSON of the scene in an exported page. */
async function sceneIn(page: string): Promise<string> {
  const [, base64] = /id="farol-scene">([^<]*)</.exec(page)!;
  return (await readSceneFile(Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)))).text;
}

test.each([true, false])('a page and a link have the scripts of the scene, or not: %s', async (withScripts) => {
  const scene = scriptedScene();
  const page = await (await exportHtml(scene, { withScripts })).text();
  expect(page).toMatch(/<noscript><p>This page shows a scene with JavaScript .*<\/p><\/noscript>/);
  expect(/farolScripts/.test(page)).toBe(withScripts);
  expect(/class Spy/.test(await sceneIn(page))).toBe(withScripts);
  expect(asked).toEqual([withScripts ? '/farol-player-scripts.js' : '/farol-player.js']);
  expect(/class Spy/.test(await decodeLink(await linkHash(scene, { withScripts })))).toBe(withScripts);
});
