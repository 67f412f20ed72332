import { shortText } from '@farol/editing';
import type { FieldTable, FieldValue } from '@farol/editing/fields';
import type { Component } from './Component';
import type { ComponentClass, ComponentData } from './ComponentClass';
import { fits } from './changeClass';
import { makeUnknownComponent } from './UnknownComponent';

/** Options of the constructor of ComponentRegistry. */
export interface ComponentRegistryOptions {
  /**
   * Whether files may hold components of types that nobody registered: each is kept as data, an `UnknownComponent`.
   * When the option is absent, such files are refused.
   */
  keepUnknown?: boolean;
}

/** The types of components that files and menus may name. */
export class ComponentRegistry {
  /** Whether files may hold components of types that nobody registered. */
  readonly keepsUnknown: boolean;

  private readonly classes = new Map<string, ComponentClass>();

  /** @param classes - initial types, such as those of another registry */
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
    if (known && known !== componentClass)
      throw new Error(`The component '${typeName}' exists already: choose another name.`);
    this.classes.set(typeName, componentClass);
    return this;
  }

  /** Removes a type: components of the type can no longer be added by name. Existing ones stay. */
  unregister(componentClass: ComponentClass): void {
    if (this.classes.get(componentClass.typeName) === componentClass) this.classes.delete(componentClass.typeName);
  }

  /**
   * The fields of a type; no fields for an unknown type, where unknown types are kept.
   * @throws Error for an unknown type, where those are refused
   */
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

  /**
   * Makes a component on no object from the data of a checked file. With `keepsUnknown`, unknown types are accepted,
   * and values that the class of an edited script no longer has or allows are left out.
   */
  createFrom(data: ComponentData): Component {
    if (this.keepsUnknown && !this.classes.has(data.type)) return makeUnknownComponent(data);
    if (!this.keepsUnknown) return this.create(data.type, data.values);
    // a script may have been edited since the data were written: values that no longer fit are left out
    const type = this.get(data.type);
    const component = new type();
    for (const name of Object.keys(data.values)) {
      const value = data.values[name];
      if (fits(type, name, value, null)) component.set(name, value);
    }
    return component;
  }

  /** A new component on no object. @throws Error for an unknown type, FieldError for a wrong value */
  create(typeName: string, values: Readonly<Record<string, FieldValue>> = {}): Component {
    const component = new (this.get(typeName))();
    for (const name of Object.keys(values)) component.set(name, values[name]);
    return component;
  }
}
