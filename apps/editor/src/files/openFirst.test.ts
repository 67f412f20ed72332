import { AssetLibrary, Light, type Scene } from '@farol/engine';
import { expect, it } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { openFirst } from './openFirst';

it('shows the temple in the evening: its first frame without shadows, which come with the next', async () => {
  const casts = (scene: Scene): string[] =>
    scene.componentsOf(Light).flatMap(({ castShadow, type }) => (castShadow ? [type] : []));
  const shown: { readonly scene: Scene; readonly casts: readonly string[] }[] = [];
  let redraws = 0;
  const editor = {
    show: (scene: Scene) => shown.push({ scene, casts: casts(scene) }),
    viewport: { invalidate: () => redraws++ },
  } as unknown as EditorApi;
  await openFirst(editor, null, (build) => build(new AssetLibrary()));
  const [{ scene, casts: atFirst }] = shown;
  expect(scene.name).toBe('Temple');
  expect(scene.settings.toneMapping).toBe('neutral');
  expect(atFirst).toEqual([]);
  expect(casts(scene)).toEqual(['directional']);
  expect(redraws).toBe(1);
});
