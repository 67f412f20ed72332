import { shortText } from '@farol/editing';
import type { FieldTable, FieldValue } from '@farol/editing/fields';
import type {
  Component,
  ComponentClass,
  ComponentData,
  ComponentRegistry as ComponentRegistryType,
} from './SceneGraph';
import { fits } from './changeClass';
import { makeUnknownComponent } from './UnknownComponent';

export interface ComponentRegistryOptions {
  /**
   * Whether files may hold components of types that nobody registered: each is kept as data, an `UnknownComponent`. They
   * are refused when absent.
   */
  keepUnknown?: boolean;
}

/** See the interface. */
class BaseComponentRegistry implements ComponentRegistryType {
  readonly keepsUnknown: boolean;

  private readonly classes = new Map<string, ComponentClass>();

  constructor(classes: Iterable<ComponentClass> = [], { keepUnknown = false }: ComponentRegistryOptions = {}) {
    this.keepsUnknown = keepUnknown;
    for (const each of classes) this.register(each);
  }

  get types(): ReadonlyMap<string, ComponentClass> {
    return this.classes;
  }

  register(componentClass: ComponentClass): this {
    const { typeName } = componentClass;
    if (!typeName) throw new Error(`The class ${componentClass.name} needs a static typeName.`);
    const known = this.classes.get(typeName);
    if (known && known !== componentClass) throw new Error(`Another component is called '${typeName}' already.`);
    this.classes.set(typeName, componentClass);
    return this;
  }

  unregister(componentClass: ComponentClass): void {
    if (this.classes.get(componentClass.typeName) === componentClass) this.classes.delete(componentClass.typeName);
  }

  fieldsOf(typeName: string): FieldTable {
    return this.keepsUnknown && !this.classes.has(typeName) ? {} : this.get(typeName).fields;
  }

  get(typeName: string): ComponentClass {
    const found = this.classes.get(typeName);
    if (!found) {
      const known = [...this.classes.keys()].join(', ');
      throw new Error(`Unknown component '${shortText(typeName)}'; known: ${known}. Register its class first.`);
    }
    return found;
  }

  createFrom(data: ComponentData): Component {
    if (this.keepsUnknown && !this.classes.has(data.type)) return makeUnknownComponent(data);
    if (!this.keepsUnknown) return this.create(data.type, data.values);
    // the class of a script may have other fields than when the data were written
    const type = this.get(data.type);
    const component = new type();
    for (const name of Object.keys(data.values)) {
      const value = data.values[name];
      if (fits(type, name, value, null)) component.set(name, value);
    }
    return component;
  }

  create(typeName: string, values: Readonly<Record<string, FieldValue>> = {}): Component {
    const component = new (this.get(typeName))();
    for (const name of Object.keys(values)) component.set(name, values[name]);
    return component;
  }
}

export type ComponentRegistry = ComponentRegistryType;

/** @param classes - types to begin with, such as those of another registry */
export const ComponentRegistry: new (
  classes?: Iterable<ComponentClass>,
  options?: ComponentRegistryOptions,
) => ComponentRegistry = BaseComponentRegistry;
