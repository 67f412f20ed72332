import type { Command } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import { instantiatePrefab, type Prefab } from '@farol/engine/prefabs';
import type { EditorApi } from '../../api/EditorApi';
import { Sequence } from '../../model/commands/Sequence';
import { addObject } from '../../model/edits';
import { canPlacePrefab } from '../../model/prefabEdits';
import { land } from '../../viewport/placing/land';
import { landingView, loadShapes, pointInPicture } from '../landInPicture';
import type { DropPlace } from '../placeAsset';

/** A prefab for a scene, and commands that add what the prefab needs and the scene lacks. */
export interface Brought {
  readonly prefab: Prefab;
  readonly steps: readonly (() => Command)[];
}

interface InstanceSteps {
  /** Called when the meshes of the prefab are loaded. */
  bring(): Brought;
  /** Makes commands that follow, in the same undo step, the one that adds the instance. */
  follow?(instance: GameObject): readonly (() => Command)[];
}

/** Places an instance of a prefab, as one undo step; at the top of the tree if the parent is within that prefab. */
export async function placeInstance(
  editor: EditorApi,
  sampled: Prefab,
  place: DropPlace,
  { bring, follow }: InstanceSteps,
): Promise<void> {
  const { document, commands } = editor;
  const { scene, selection } = document;
  const sample = instantiatePrefab(sampled, scene.registry);
  await loadShapes(editor, [sample]);
  sample.dispose();
  if (scene !== document.scene) return;
  const { prefab, steps } = bring();
  const instance = instantiatePrefab(prefab, scene.registry);
  const { parent = scene } = place;
  const container = canPlacePrefab(scene, prefab, parent) ? parent : scene;
  if (container === scene) {
    // computed before `landingView`: `pointInPicture` activates the view under the pointer, which `landingView` reads
    const point = pointInPicture(editor, place.at);
    land(landingView(editor), [instance], point);
  }
  const put = addObject(scene, instance, container, selection.ids);
  commands.run(new Sequence(put.label, [...steps, () => put, ...(follow?.(instance) ?? [])], put.selection));
}
