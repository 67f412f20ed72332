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
import { materialEdits, newFieldAsset } from './assetEdits';
import { AddAssets } from './commands/AddAssets';
import { Sequence } from './commands/Sequence';

/** A command that adds a surface, with the names of what it adds. */
export interface MadeSurface {
  readonly command: Command;
  readonly surface: string;
  /** Name of the material that uses the surface; null when no object got one. */
  readonly material: string | null;
}

/** Component by which an object uses a surface. */
export type SurfaceWearer = ObjectRenderer | ModelRenderer;

/** Components by which objects can use surfaces. */
export const surfaceWearers = (objects: readonly GameObject[]): SurfaceWearer[] =>
  objects.flatMap((object) => object.getComponent(ObjectRenderer) ?? object.getComponent(ModelRenderer) ?? []);

/**
 * Adds a surface, and a material with it for objects.
 * @param name - a number is added when it is taken
 * @param values - values of the new material
 * @param users - objects that get the material, in the same step; no material is made without any. Models get the
 *   surface directly
 * @param needsGrid - replaces planes by grids, whose vertices the surface moves
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
    () => new SetFields(label, [...materialEdits(renderers, material.name), ...(needsGrid ? gridsOf(renderers) : [])]),
  ]);
  return { command, surface: made.name, material: material.name };
}

const gridsOf = (users: readonly ObjectRenderer[]): FieldEdit[] =>
  users.filter(({ mesh }) => mesh === 'plane').map((owner) => ({ owner, name: 'mesh', value: 'grid' }));

/**
 * Makes objects use a surface directly, in place of their material's; each object then has uniform values of its own.
 */
export function wearSurface(surface: string, users: readonly SurfaceWearer[]): Command {
  const label = t('Gave {asset} to {object}', {
    asset: surface,
    object: namesOf(users.map(({ gameObject }) => gameObject)),
  });
  return new SetFields(label, wearing(users, surface));
}

const wearing = (users: readonly SurfaceWearer[], surface: string): FieldEdit[] =>
  users.flatMap((owner): FieldEdit[] => [
    // the custom shader is removed, since an ObjectRenderer that has one ignores surfaces
    ...(owner instanceof ObjectRenderer ? [{ owner, name: 'shader', value: null }] : []),
    { owner, name: 'surface', value: surface },
  ]);

/**
 * Makes objects use the surface of their material directly, with the material's uniform values as a start.
 * @param material - a library material that has a surface
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
