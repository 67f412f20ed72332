import { Vector3 } from 'three';
import { expect, it } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { lookFrom, sides } from './viewpoint';

it.each(sides)('looks from %s by the camera of the editor, not through one of the scene', (side, direction) => {
  const done: unknown[] = [];
  const viewport = {
    lookThrough: {} as unknown,
    editorCamera: { lookFrom: (from: Vector3, isFlat: boolean) => done.push(from.toArray(), isFlat) },
    viewChanged: () => done.push('viewChanged'),
  };
  void lookFrom.find(({ id }) => id === `view.${side}`)!.run({ viewport } as unknown as EditorApi);
  expect(viewport.lookThrough).toBeNull();
  expect(done).toEqual([direction, true, 'viewChanged']);
});
