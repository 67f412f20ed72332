import type { FieldTable, FieldValue } from '../fields/Field';
import { type FieldOwner, type FieldViews, sameValue } from '../fields/FieldOwner';
import type { SurfaceAsset } from './SurfaceAsset';
import { readStored, storedValue, type StoredValues, UNIFORM, writeStored } from './uniformFields';

/** The uniforms of a surface as fields of what wears it, 'surface.height': see `surfaceValueFields`. */
export class UniformViews implements FieldViews {
  private table: FieldTable;
  private uniforms: FieldTable | null = null;
  private stored: StoredValues = {};
  private storedText = '';

  /**
   * @param owner - has the fields `surfaceValueFields`
   * @param declared - all that it declares
   * @param surface - finds what is worn at the moment
   */
  constructor(
    private readonly owner: FieldOwner,
    private readonly declared: FieldTable,
    private readonly surface: () => SurfaceAsset | null,
  ) {
    this.table = declared;
  }

  get fields(): FieldTable {
    const uniforms = this.surface()?.uniformFields ?? null;
    if (uniforms !== this.uniforms) {
      this.uniforms = uniforms;
      this.table = uniforms ? { ...this.declared, ...uniforms } : this.declared;
    }
    return this.table;
  }

  has(name: string): boolean {
    return name.startsWith(UNIFORM) && Object.hasOwn(this.fields, name);
  }

  get(name: string): FieldValue {
    const field = this.fields[name];
    if (field.viewOf !== 'surfaceValues') return this.owner.getAuthored(field.viewOf!);
    return storedValue(field, this.values[name.slice(UNIFORM.length)]);
  }

  set(name: string, value: FieldValue): void {
    const field = this.fields[name];
    if (field.viewOf !== 'surfaceValues') return this.owner.set(field.viewOf!, value);
    const { [name.slice(UNIFORM.length)]: _before, ...others } = this.values;
    const isDefault = sameValue(value, field.default);
    this.owner.set(
      'surfaceValues',
      writeStored(isDefault ? others : { ...others, [name.slice(UNIFORM.length)]: value }),
    );
  }

  private get values(): StoredValues {
    const text = this.owner.getAuthored('surfaceValues') as string;
    if (text !== this.storedText) {
      this.stored = readStored(text);
      this.storedText = text;
    }
    return this.stored;
  }
}
