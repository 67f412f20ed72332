import { type Command, type FieldEdit, namesOf, SetFields, t } from '@farol/editing';
import {
  type GameObject,
  type MaterialAsset,
  ModelRenderer,
  ObjectRenderer,
  type Scene,
  type TakenAsset,
} from '@farol/engine';
import { type FieldValue, surfaceValueFields } from '@farol/engine/fields';
import { newFieldAsset } from './assetEdits';
import { AddAssets } from './commands/AddAssets';
import { Sequence } from './commands/Sequence';

/** A command that makes a surface, with the names of what it makes. */
export interface MadeSurface {
  readonly command: Command;
  readonly surface: string;
  /** Of the material that wears it; null where no object does. */
  readonly material: string | null;
}

/** What an object wears a surface by. */
export type SurfaceWearer = ObjectRenderer | ModelRenderer;

/** What objects can wear surfaces by. */
export const surfaceWearers = (objects: readonly GameObject[]): SurfaceWearer[] =>
  objects.flatMap((object) => object.getComponent(ObjectRenderer) ?? object.getComponent(ModelRenderer) ?? []);

/**
 * Adds a surface, and a material that wears it to objects.
 * @param name - wanted; it gets a number where it is taken
 * @param values - of the new material
 * @param users - objects that get the material, in the same step; without any there is no material. Models wear it themselves
 * @param needsGrid - planes become grids, which have vertices to move
 */
export function addSurface(
  scene: Scene,
  name: string,
  source: string,
  values: Readonly<Record<string, FieldValue>>,
  users: readonly SurfaceWearer[],
  needsGrid = false,
): MadeSurface {
  const { assets } = scene;
  const made = newFieldAsset(assets, 'surface', name, { source });
  const label =
    users.length === 0
      ? t('Made surface {name}', { name: made.name })
      : t('Made surface {name} for {objects}', {
          name: made.name,
          objects: namesOf(users.map(({ gameObject }) => gameObject)),
        });
  const renderers = users.filter((user) => user instanceof ObjectRenderer);
  const models = users.filter((user) => user instanceof ModelRenderer);
  const steps = [
    () => new AddAssets(assets, [made]),
    ...(models.length > 0 ? [() => new SetFields(label, wearing(models, made.name))] : []),
  ];
  if (renderers.length === 0) return { command: new Sequence(label, steps), surface: made.name, material: null };
  const material = newFieldAsset(assets, 'material', t('{name} material', { name: made.name }), {
    ...values,
    surface: made.name,
  });
  const taken: TakenAsset[] = [material];
  const command = new Sequence(label, [
    ...steps,
    () => new AddAssets(assets, taken),
    () => new SetFields(label, [...editsOf(renderers, material.name), ...(needsGrid ? gridsOf(renderers) : [])]),
  ]);
  return { command, surface: made.name, material: material.name };
}

const gridsOf = (users: readonly ObjectRenderer[]): FieldEdit[] =>
  users.filter(({ mesh }) => mesh === 'plane').map((owner) => ({ owner, name: 'mesh', value: 'grid' }));

const editsOf = (users: readonly ObjectRenderer[], material: string): FieldEdit[] =>
  users.flatMap((owner): FieldEdit[] => [
    { owner, name: 'shader', value: null },
    { owner, name: 'material', value: material },
  ]);

/** Has objects wear a surface by themselves, over what their materials wear; its values are each object's own. */
export function wearSurface(surface: string, users: readonly SurfaceWearer[]): Command {
  const label = t('Gave {asset} to {object}', {
    asset: surface,
    object: namesOf(users.map(({ gameObject }) => gameObject)),
  });
  return new SetFields(label, wearing(users, surface));
}

const wearing = (users: readonly SurfaceWearer[], surface: string): FieldEdit[] =>
  users.flatMap((owner): FieldEdit[] => [
    // a shader of one's own cannot wear it
    ...(owner instanceof ObjectRenderer ? [{ owner, name: 'shader', value: null }] : []),
    { owner, name: 'surface', value: surface },
  ]);

/**
 * Has an object wear the surface of its material by itself, with the values that it has there, so that they can be its own.
 * @param material - of the library, which wears one
 */
export function ownSurfaceValues(users: readonly ObjectRenderer[], material: MaterialAsset): Command {
  const label = t('Own values of {surface} for {objects}', {
    surface: material.get('surface') as string,
    objects: namesOf(users.map(({ gameObject }) => gameObject)),
  });
  const names = ['surface', ...Object.keys(surfaceValueFields)];
  return new SetFields(
    label,
    users.flatMap((owner) => names.map((name): FieldEdit => ({ owner, name, value: material.getAuthored(name) }))),
  );
}
