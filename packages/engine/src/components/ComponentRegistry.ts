import { shortText } from '@farol/renderer';
import type { Component, ComponentClass } from '../core/Component';
import type { FieldTable, FieldValue } from '../fields/Field';
import { type ComponentData, makeUnknownComponent } from './UnknownComponent';

export interface ComponentRegistryOptions {
  /**
   * Whether files may hold components of types that nobody registered: each is kept as data, an `UnknownComponent`. They
   * are refused when absent.
   */
  keepUnknown?: boolean;
}

/** The types of components that files and menus may name. */
export class ComponentRegistry {
  /** Whether files may hold components of types that nobody registered. */
  readonly keepsUnknown: boolean;

  private readonly classes = new Map<string, ComponentClass>();

  /** @param classes - types to begin with, such as those of another registry */
  constructor(classes: Iterable<ComponentClass> = [], { keepUnknown = false }: ComponentRegistryOptions = {}) {
    this.keepsUnknown = keepUnknown;
    for (const each of classes) this.register(each);
  }

  /** Every type by its name, in the order of registration. */
  get types(): ReadonlyMap<string, ComponentClass> {
    return this.classes;
  }

  /** Adds a type. @throws Error when it has no name, or the name is another class's */
  register(componentClass: ComponentClass): this {
    const { typeName } = componentClass;
    if (!typeName) throw new Error(`The class ${componentClass.name} needs a static typeName.`);
    const known = this.classes.get(typeName);
    if (known && known !== componentClass) throw new Error(`Another component is called '${typeName}' already.`);
    this.classes.set(typeName, componentClass);
    return this;
  }

  /** Takes a type out: no more of it can be added by name. Components of it that there are stay what they are. */
  unregister(componentClass: ComponentClass): void {
    if (this.classes.get(componentClass.typeName) === componentClass) this.classes.delete(componentClass.typeName);
  }

  /** The fields of a type; none of one that is not known, where those are kept. @throws Error for one that is refused */
  fieldsOf(typeName: string): FieldTable {
    return this.keepsUnknown && !this.classes.has(typeName) ? {} : this.get(typeName).fields;
  }

  /** @throws Error naming the types that there are */
  get(typeName: string): ComponentClass {
    const found = this.classes.get(typeName);
    if (!found) {
      const known = [...this.classes.keys()].join(', ');
      throw new Error(`Unknown component '${shortText(typeName)}'; known: ${known}. Register its class first.`);
    }
    return found;
  }

  /** A component on no object from the data of a checked file, of a type that is not known too where those are kept. */
  createFrom(data: ComponentData): Component {
    if (this.keepsUnknown && !this.classes.has(data.type)) return makeUnknownComponent(data);
    return this.create(data.type, data.values);
  }

  /** A new component on no object. @throws Error for an unknown type, FieldError for a wrong value */
  create(typeName: string, values: Readonly<Record<string, FieldValue>> = {}): Component {
    const component = new (this.get(typeName))();
    for (const name of Object.keys(values)) component.set(name, values[name]);
    return component;
  }
}
