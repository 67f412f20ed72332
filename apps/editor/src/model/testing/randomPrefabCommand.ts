import type { Command } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import { instanceRootOf, instantiatePrefab, overridesOf, PrefabError } from '@farol/engine/prefabs';
import type { Container } from '../commands/Placement';
import { addObject } from '../edits';
import type { EditorDocument } from '../EditorDocument';
import {
  applyField,
  applyInstance,
  canPlacePrefab,
  createPrefab,
  deletePrefab,
  renamePrefab,
  revertField,
  revertInstance,
  unpackInstance,
} from '../prefabEdits';
import { below, pick, type Random } from './random';

/** A random edit of prefabs; an object that is not in an instance is made into a prefab. */
export function randomPrefabCommand(
  random: Random,
  { scene }: EditorDocument,
  object: GameObject,
  parent: Container,
): Command {
  const root = instanceRootOf(object);
  if (!root) return createPrefab(scene, object, []);
  const prefab = pick(random, scene.prefabs.list);
  switch (below(random, 9)) {
    case 0: {
      const container = canPlacePrefab(scene, prefab, parent) ? parent : scene;
      return addObject(scene, instantiatePrefab(prefab, scene.registry), container, []);
    }
    case 1:
      return applyField(scene, object.transform, 'scale', []);
    case 2:
      return revertInstance(scene, root, []);
    case 3:
      return unpackInstance(scene, root, []);
    case 4:
      return deletePrefab(scene, prefab, []);
    case 5: {
      const own = pick(random, overridesOf(root).fields);
      return own ? revertField(scene, own, []) : revertInstance(scene, root, []);
    }
    case 6:
    case 7:
      try {
        return applyInstance(scene, root, []);
      } catch (error) {
        // refused, and nothing changed: the prefab would contain itself
        if (!(error instanceof PrefabError)) throw error;
        return unpackInstance(scene, root, []);
      }
    default:
      return renamePrefab(scene, prefab, `Prefab ${below(random, 100)}`);
  }
}
