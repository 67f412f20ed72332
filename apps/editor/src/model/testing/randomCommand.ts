import type { Command } from '@farol/editing';
import { builtinComponents, Camera, GameObject } from '@farol/engine';
import { addPhysics, type PhysicsKind } from '../addPhysics';
import { copyObjects, pasteObjects } from '../clip';
import type { Container } from '../commands/Placement';
import { SetMicroShaders } from '../commands/SetMicroShaders';
import { SetProperty } from '../commands/SetProperty';
import {
  addComponent,
  addObject,
  canMoveTo,
  deleteObjects,
  duplicateObjects,
  moveComponents,
  moveObjects,
  removeComponents,
  renameObject,
  resetFields,
  setActive,
  setEnabled,
  setLocked,
  setStatic,
  setValues,
} from '../edits';
import type { EditorDocument } from '../EditorDocument';
import { groupObjects, ungroupObjects } from '../groupObjects';
import { below, objectsOf, pick, type Random } from './random';
import { randomArrangement } from './randomArrangement';
import { randomAssetCommand } from './randomAssetCommand';
import { randomBakeCommand } from './randomBakeCommand';
import { randomClipCommand } from './randomClipCommand';
import { randomEdit } from './randomEdit';
import { randomMaterialCommand } from './randomMaterialCommand';
import { randomPrefabCommand } from './randomPrefabCommand';
import { randomRunningScript } from './randomRunningScript';
import { randomScriptCommand } from './randomScriptCommand';
import { randomSurfaceCommand } from './randomSurfaceCommand';
import { randomViewCommand } from './randomViewCommand';

/** A random subset of about two objects, often nested. */
const some = (random: Random, all: readonly GameObject[]): GameObject[] => {
  const chosen = all.filter(() => random() < 2 / all.length);
  return chosen.length > 0 ? chosen : [pick(random, all)];
};

function randomMicroShaders(random: Random, { scene }: EditorDocument): Command {
  const names = ['heatMap', 'own/a', 'own/b'].filter(() => random() < 0.6);
  const text = (): string | null => (random() < 0.3 ? null : `float v${below(random, 1000)};`);
  return new SetMicroShaders(
    'Edit microshaders',
    scene,
    names.map((name) => ({ name, text: text() })),
  );
}

/** A random edit of any kind, for a scene of 6 to 40 objects. */
export function randomCommand(random: Random, document: EditorDocument): Command {
  const { scene, selection } = document;
  const all = objectsOf(scene);
  const parent = (): Container => (all.length === 0 || random() < 0.3 ? scene : pick(random, all));
  const kind = all.length < 6 ? 0 : all.length > 40 ? 1 : below(random, 45);
  switch (kind) {
    case 0: {
      const object = new GameObject(`Object ${below(random, 1000)}`);
      if (random() < 0.7) {
        const type = pick(random, [...builtinComponents.types.values()].slice(1));
        object.addComponent(type);
      }
      return addObject(scene, object, parent(), selection.ids);
    }
    case 1:
      return deleteObjects(scene, some(random, all));
    case 2:
      return duplicateObjects(scene, some(random, all).slice(0, 2));
    case 3: {
      const target = parent();
      const objects = some(random, all);
      return canMoveTo(objects, target) ? moveObjects(scene, objects, target) : moveObjects(scene, objects, scene, 0);
    }
    case 4: {
      const object = pick(random, all);
      return moveObjects(scene, [object], object.parent ?? scene, below(random, 4));
    }
    case 5:
      return renameObject(pick(random, all), `Name ${below(random, 1000)}`);
    case 6:
      return setActive(some(random, all), random() < 0.5);
    case 7:
      return setEnabled(pick(random, all).components, random() < 0.5);
    case 8:
      return addComponent(scene, some(random, all), pick(random, [...builtinComponents.types.values()]));
    case 9:
      return removeComponents(
        scene,
        pick(random, all).components.filter((component) => component.typeName !== 'Transform'),
      );
    case 10:
      return randomEdit(random, document, scene.settings);
    case 11:
      return setLocked(some(random, all), random() < 0.5);
    case 12:
      return groupObjects(scene, some(random, all));
    case 13:
      return ungroupObjects(scene, some(random, all));
    case 14:
      return pasteObjects(scene, copyObjects(scene, some(random, all).slice(0, 2)).text, parent(), selection.ids);
    case 15:
      return moveComponents(pick(random, all).components.slice(-1), random() < 0.5 ? -1 : 1);
    case 16: {
      const { components } = pick(random, all);
      const from = pick(random, components);
      const to = pick(random, all).components.filter(({ typeName }) => typeName === from.typeName);
      return setValues('Paste values', to, from.authoredValues());
    }
    case 17:
      return resetFields('Reset', [pick(random, pick(random, all).components)]);
    case 18:
      return randomMicroShaders(random, document);
    case 19:
      return new SetProperty('Rename scene', [scene], 'name', `Scene ${below(random, 100)}`);
    case 20:
      return new SetProperty(
        'Set camera',
        [scene],
        'activeCamera',
        scene.componentsOf(Camera)[below(random, scene.componentsOf(Camera).length)] ?? null,
      );
    case 21:
    case 22:
    case 23:
    case 24:
    case 25:
      return randomPrefabCommand(random, document, pick(random, all), parent());
    case 26:
      return randomAssetCommand(random, document);
    case 27:
    case 28:
      return randomMaterialCommand(random, document);
    case 29:
      return randomArrangement(random, scene, some(random, all).slice(0, 2));
    case 30:
      return randomViewCommand(random, document);
    case 31:
    case 32:
      // edits of scripts survive stopping, so that none is made while the scene plays
      return document.simulation.state === 'stopped'
        ? randomScriptCommand(random, document, some(random, all))
        : randomEdit(random, document, scene.settings);
    case 33:
      return randomClipCommand(random, document, pick(random, all));
    case 34:
    case 35:
      return randomRunningScript(random, document) ?? randomEdit(random, document, scene.settings);
    case 38:
    case 39:
      return randomBakeCommand(random, document);
    case 40:
      return setStatic(some(random, all), random() < 0.5);
    case 41:
    case 42:
    case 43:
    case 44:
      return randomSurfaceCommand(random, document);
    case 36: {
      const kinds: readonly PhysicsKind[] = ['dynamic', 'kinematic', 'fixed', 'character'];
      return addPhysics(scene, some(random, all), pick(random, kinds));
    }
    default: {
      // components of scripts that do not run have no editable fields
      const owners = pick(random, all).components.filter(({ fields }) =>
        Object.values(fields).some((field) => field.default !== undefined),
      );
      return randomEdit(random, document, pick(random, owners));
    }
  }
}
