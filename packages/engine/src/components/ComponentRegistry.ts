import { shortText } from '@farol/renderer';
import type { Component, ComponentClass } from '../core/Component';
import type { FieldValue } from '../fields/Field';

/** The types of components that files and menus may name. */
export class ComponentRegistry {
  private readonly classes = new Map<string, ComponentClass>();

  /** @param classes - types to begin with, such as those of another registry */
  constructor(classes: Iterable<ComponentClass> = []) {
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

  /** @throws Error naming the types that there are */
  get(typeName: string): ComponentClass {
    const found = this.classes.get(typeName);
    if (!found) {
      const known = [...this.classes.keys()].join(', ');
      throw new Error(`Unknown component '${shortText(typeName)}'; known: ${known}. Register its class first.`);
    }
    return found;
  }

  /** A new component on no object. @throws Error for an unknown type, FieldError for a wrong value */
  create(typeName: string, values: Readonly<Record<string, FieldValue>> = {}): Component {
    const component = new (this.get(typeName))();
    for (const name of Object.keys(values)) component.set(name, values[name]);
    return component;
  }
}
