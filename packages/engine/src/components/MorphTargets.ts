import { type Field, type FieldTable, type FieldValue, number, string } from '@farol/editing/fields';
import { Mesh, type Object3D } from 'three';
import type { Model } from '../assets/Model';

/** Prefix of field names for weights of morph targets, such as 'morph.Smile'. */
const MORPH = 'morph.';

/** Title of the group of morph target fields in the inspector. */
const GROUP = 'Morph targets';

/** Name of the field for the weight of a morph target. */
export const morphField = (name: string): string => MORPH + name;

/** Greatest number of a model's morph targets that get fields; models of faces have 50 to 80. */
const MOST_FIELDS = 256;

/** Fields that store a model's morph target weights, for owners with a field `model`. */
export const morphTargetFields = {
  /** JSON of weights that differ from the model's, by name of the morph target. */
  morphWeights: string('', {
    visibleWhen: { field: 'model', equals: [] },
    help: 'Weights of the morph targets.',
    label: GROUP,
    readOnly: true,
  }),
};

/** Weight of a morph target of one mesh, stored in `influences[index]`. */
interface Use {
  readonly influences: number[];
  readonly index: number;
}

/** Field tables by model and drawn parts, so that all copies share one. */
const tables = new WeakMap<Model, Map<string, FieldTable | null>>();

function fieldsOf(defaults: ReadonlyMap<string, number>): FieldTable | null {
  if (defaults.size === 0) return null;
  const fields: Record<string, Field> = {};
  for (const [name, weight] of defaults) {
    fields[morphField(name)] = number(weight, {
      min: Math.min(0, weight),
      max: Math.max(1, weight),
      step: 0.01,
      label: name,
      group: GROUP,
      help: 'How much of the morph target is added.',
      viewOf: 'morphWeights',
    });
  }
  return fields;
}

/**
 * Morph targets of a model's drawn parts. Targets of one name on several meshes, such as face and teeth, share one
 * weight.
 */
export class MorphTargets {
  /** Field for each morph target, see `Field.viewOf`; null where there are none. */
  readonly fields: FieldTable | null;
  private readonly uses = new Map<string, Use[]>();

  /** @param copies - copies of the model's drawn nodes @param parts - drawn part of the model */
  constructor(
    private readonly owner: { get(name: string): FieldValue },
    model: Model,
    parts: string,
    copies: ReadonlyMap<Object3D, Object3D>,
  ) {
    /** Weights of the morph targets as the model's file has them, by name. */
    const defaults = new Map<string, number>();
    for (const [from, to] of copies) {
      if (!(from instanceof Mesh && to instanceof Mesh)) continue;
      for (const [name, index] of Object.entries(from.morphTargetDictionary ?? {})) {
        if (defaults.size === MOST_FIELDS && !defaults.has(name)) continue;
        const weight = from.morphTargetInfluences![index];
        if (!defaults.has(name)) defaults.set(name, Number.isFinite(weight) ? weight : 0);
        const uses = this.uses.get(morphField(name)) ?? [];
        uses.push({ influences: to.morphTargetInfluences!, index });
        this.uses.set(morphField(name), uses);
      }
    }
    const known = tables.get(model) ?? new Map<string, FieldTable | null>();
    tables.set(model, known);
    if (!known.has(parts)) known.set(parts, fieldsOf(defaults));
    this.fields = known.get(parts)!;
  }

  /** Writes the weights of all morph targets to the meshes. */
  show(): void {
    for (const name of this.uses.keys()) this.showOne(name);
  }

  /** Applies a changed field of the owner. @returns whether the field is a morph target's */
  fieldChanged(name: string): boolean {
    if (name === 'morphWeights') this.show();
    else if (name.startsWith(MORPH)) this.showOne(name);
    else return false;
    return true;
  }

  private showOne(name: string): void {
    const uses = this.uses.get(name);
    if (uses === undefined) return;
    const weight = this.owner.get(name) as number;
    for (let i = 0; i < uses.length; i++) uses[i].influences[uses[i].index] = weight;
  }
}
