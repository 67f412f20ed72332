import { AssetLibrary, Scene } from '@farol/engine';
import { expect, test } from 'vitest';
import { linkHash } from './shareLink';

test('a scene too large for a link is told with the names of its largest assets, short', async () => {
  const assets = new AssetLibrary();
  for (const i of [1, 2, 3]) {
    assets.registerFile(`${i}${'%x'.repeat(20_000)}.glb`, new Blob([new Uint8Array(300_000)]));
  }
  const message = await linkHash(new Scene({ assets })).catch((error: Error) => error.message);
  expect(message).toMatch(/^The link would have .* The largest assets are .*1%x%x.* Export a web page instead\.$/);
  expect(message.length).toBeLessThan(500);
});

test('names with halves of letters are saved as any other', async () => {
  const assets = new AssetLibrary();
  assets.registerFile('half \ud83d.ply', new Blob(['ply']));
  assets.registerFile('..', new Blob(['ply']), 'mesh');
  expect(await linkHash(new Scene({ assets }))).toMatch(/^#scene=/);
});
