import { type GameObject, Light, type Scene } from '@farol/engine';
import { formatIntensity } from '@farol/engine/photometry';
import type { FieldOwner } from '@farol/engine/fields';
import type { ToolInput } from '@farol/mcp/tools';
import { Vector3 } from 'three';
import { z } from 'zod';
import type { EditorApi } from '../api/EditorApi';
import type { ConsoleKind } from '../model/ConsoleLog';
import { creationNames } from './creationNames';
import { rangeOf, schemaOfFields, shownValue, unitOf } from './fieldValues';
import { findObject, pathOf } from './findObjects';

const short = (value: number): number => Number(value.toFixed(3)) + 0;
const triple = (value: Vector3): number[] => value.toArray().map(short);

/** One line of the tree that `get_scene` answers with: an object. */
function lineOf(object: GameObject, depth: number): string {
  const types = object.components.slice(1).map(({ typeName }) => typeName);
  const light = object.getComponent(Light);
  const flags = [
    !object.active && 'hidden',
    object.locked && 'locked',
    object.isStatic && 'static',
    object.prefabLink && 'of a prefab',
  ].filter(Boolean);
  const parts = [
    `${'  '.repeat(depth)}${object.name} (${object.id})`,
    types.length > 0 ? `[${types.join(', ')}]` : '',
    light ? `${light.type} light` : '',
    `at ${triple(object.transform.worldPosition).join(', ')}`,
    flags.join(', '),
  ];
  return parts.filter(Boolean).join(' ');
}

/** Lines of all objects below a root, and how many were left out. */
function treeOf(scene: Scene, { below, find, most = 200 }: ToolInput<'get_scene'>): object {
  const lines: string[] = [];
  const asked = find?.toLowerCase();
  let left = 0;
  const visit = (object: GameObject, depth: number): void => {
    const words = [object.name, ...object.components.map(({ typeName }) => typeName)].join('\n').toLowerCase();
    if (asked === undefined || words.includes(asked)) {
      if (lines.length < most) lines.push(lineOf(object, asked === undefined ? depth : 0));
      else left++;
    }
    for (const child of object.children) visit(child, depth + 1);
  };
  for (const root of below === undefined ? scene.roots : [findObject(scene, below)]) visit(root, 0);
  return { objects: lines, ...(left > 0 && { more: left }) };
}

export function getScene({ document, commands, file }: EditorApi, input: ToolInput<'get_scene'>): object {
  const { scene, simulation } = document;
  return {
    name: scene.name,
    file: file.name,
    saved: !commands.isDirty,
    play: simulation.state,
    undo: commands.undoLabel,
    redo: commands.redoLabel,
    selected: document.selectedObjects.map(pathOf),
    size: scene.size,
    ...treeOf(scene, input),
  };
}

/** Values of an owner's fields, with unit and range if asked for. */
const valuesOf = (owner: FieldOwner, bounds: boolean): object =>
  Object.fromEntries(
    Object.entries(owner.fields)
      .filter(([, { deprecated }]) => !deprecated)
      .map(([name, field]) => {
        const value = shownValue(field, owner.getAuthored(name));
        return [name, bounds ? { value, unit: unitOf(field), ...rangeOf(field) } : value];
      }),
  );

export function getObjects({ document }: EditorApi, { objects, bounds = false }: ToolInput<'get_objects'>): object {
  const { scene } = document;
  return objects.map((reference) => {
    if (reference === 'scene') return { object: 'scene', settings: valuesOf(scene.settings, bounds) };
    const object = findObject(scene, reference);
    const { active, locked, isStatic, children } = object;
    return {
      object: pathOf(object),
      id: object.id,
      ...{ active, locked, static: isStatic, children: children.map(({ name }) => name) },
      world: { position: triple(object.transform.worldPosition), front: triple(object.transform.front) },
      components: object.components.map((component) => ({
        type: component.typeName,
        ...(!component.enabled && { enabled: false }),
        values: valuesOf(component, bounds),
      })),
    };
  });
}

const ownSchema = z.strictObject({
  name: z.string().optional(),
  active: z.boolean().optional().describe('False hides it with all below it.'),
  locked: z.boolean().optional().describe('Clicks in the picture do not pick it.'),
  static: z.boolean().optional().describe('It never moves: a bake gives it lightmaps.'),
});

const jsonOf = (schema: z.ZodType): object => {
  const { $schema: _dialect, ...json } = z.toJSONSchema(schema, { io: 'input', unrepresentable: 'any' });
  return json;
};

export function describeType({ document, samples }: EditorApi, { type }: ToolInput<'describe_type'>): object {
  const { scene } = document;
  const { types } = scene.registry;
  if (type === undefined) {
    return {
      what: creationNames(scene).names,
      components: Object.fromEntries([...types.values()].map(({ typeName, help }) => [typeName, help])),
      others: ['Object', 'scene'],
      samples: Object.keys(samples),
      units: "m, °, cd, lx, s; y is up; an object's front is -Z; colours '#rrggbb' (sRGB) or linear [r, g, b]",
    };
  }
  if (type === 'Object') return jsonOf(ownSchema);
  if (type === 'scene') return jsonOf(schemaOfFields(scene.settings.fields));
  const found = types.get(type);
  if (!found)
    throw new Error(`There is no component type “${type}”: there are ${[...types.keys()].join(', ')}, Object, scene.`);
  return { help: found.help, onePerObject: found.unique, ...jsonOf(schemaOfFields(found.fields)) };
}

export function getLights({ document, viewport }: EditorApi): object {
  const { info } = viewport.farol;
  return {
    technique: info.technique,
    reason: info.reason,
    drawn: { lights: info.lights, drawCalls: info.drawCalls, triangles: info.triangles },
    lights: [...document.scene.componentsOf(Light)].map((each) => {
      const light = each as Light;
      const { gameObject: object, type, fields } = light;
      const isFar = type === 'ambient' || type === 'hemisphere' || type === 'directional';
      return {
        ...{ object: pathOf(object), id: object.id, type },
        on: light.isActive,
        position: triple(light.position),
        ...(type !== 'point' && type !== 'ambient' && { direction: triple(light.direction) }),
        colour: shownValue(fields.diffuse, light.colour),
        intensity: formatIntensity(light),
        ...(!isFar && { range: Number.isFinite(light.reach) ? `${light.reach} m` : 'no end' }),
        shadow: light.castShadow,
      };
    }),
  };
}

const kinds: readonly ConsoleKind[] = ['info', 'warning', 'error'];

export function getMessages(
  { log, dialogs }: EditorApi,
  { least = 'info', most = 50 }: ToolInput<'get_messages'>,
): object {
  const shown = log.entries.filter(({ kind }) => kinds.indexOf(kind) >= kinds.indexOf(least));
  return {
    dialog: dialogs.current ? dialogOf(dialogs.current) : null,
    messages: shown.slice(-most).map(({ kind, source, text, count, place }) => ({
      ...{ kind, source, text },
      ...(count > 1 && { count }),
      ...(place && { place }),
    })),
  };
}

/** Title of a dialog, else its kind. */
export const dialogOf = (request: object & { kind: string }): string =>
  'title' in request ? String(request.title) : request.kind;
