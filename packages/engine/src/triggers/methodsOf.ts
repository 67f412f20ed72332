import type { FieldKind } from '@farol/editing/fields';
import { builtinComponents } from '../core/builtinComponents';
import { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';

/** Methods that an EventTrigger can call on any GameObject, and on any component. */
export const objectMethods = ['activate', 'deactivate', 'toggle'] as const;
export const componentMethods = ['enable', 'disable', 'toggle'] as const;

/** Kinds of fields that accept each type of value. */
const kindsOf: Readonly<Record<string, readonly FieldKind[]>> = {
  number: ['number', 'angle'],
  flag: ['boolean'],
  text: ['string', 'choice', 'asset'],
  colour: ['colour'],
  vector: ['vector3', 'euler'],
  object: ['object'],
};

/** Methods that the engine calls: life cycle and events. */
const calledByEngine =
  /^(start|update|lateUpdate|listensTo|dispose|constructor|onDestroy|on(Pointer|Key|Collision|Trigger)\w*|_.*)$/;

/** Methods of a component's class that may be called from outside. */
function ownMethods({ componentClass }: Component): readonly string[] {
  if (componentClass.callable) return componentClass.callable;
  if (builtinComponents.types.get(componentClass.typeName) === componentClass) return [];
  const names = new Set<string>();
  for (
    let each = componentClass.prototype as object | null;
    each && each !== Component.prototype;
    each = Object.getPrototypeOf(each) as object | null
  ) {
    for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(each))) {
      const isOwn = typeof value === 'function' && !calledByEngine.test(name);
      if (isOwn && !(name in Component.prototype)) names.add(name);
    }
  }
  return [...names];
}

/**
 * Methods that an EventTrigger can call on an object: 'GameObject.activate', 'Light.toggle', 'AudioSource.play',
 * methods of its scripts, and fields that can be set to a value of the type, such as 'Light.intensity'.
 * @param valueType - see `EventTrigger.valueType`
 */
export function methodsOf(object: GameObject, valueType: string): string[] {
  const found = new Set(objectMethods.map((name) => `GameObject.${name}`));
  const kinds = kindsOf[valueType] ?? [];
  for (const component of object.components) {
    const { typeName, fields } = component;
    for (const name of ownMethods(component)) found.add(`${typeName}.${name}`);
    if (typeName !== 'Transform') for (const name of componentMethods) found.add(`${typeName}.${name}`);
    for (const [name, { kind, readOnly }] of Object.entries(fields))
      if (kinds.includes(kind) && !readOnly) found.add(`${typeName}.${name}`);
  }
  return [...found];
}
