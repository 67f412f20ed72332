import type { Component } from '@farol/engine';
import { checkFieldValue, type FieldTable, type FieldValue } from '@farol/engine/fields';

/** A copied component: its type and its authored values. */
export interface ComponentClip {
  readonly type: string;
  readonly values: Readonly<Record<string, FieldValue>>;
}

/** A component as text for the clipboard. */
export const copyComponent = (component: Component): string =>
  JSON.stringify({ format: 'farol-component', type: component.typeName, values: component.authoredValues() });

/** Reads a copied component from a clipboard's text; null when the text is something else. */
export function readComponentClip(text: string | null): ComponentClip | null {
  if (!text?.startsWith('{"format":"farol-component"')) return null;
  try {
    const { type, values } = JSON.parse(text) as Partial<ComponentClip>;
    return typeof type === 'string' && typeof values === 'object' && values !== null ? { type, values } : null;
  } catch {
    return null;
  }
}

/** Values of a copied component that fit a table of fields: a field of that name exists and allows the value. */
export function fittingValues(clip: ComponentClip, fields: FieldTable): Record<string, FieldValue> {
  return Object.fromEntries(
    Object.entries(clip.values).filter(
      ([name, value]) => Object.hasOwn(fields, name) && checkFieldValue(fields[name], value) === null,
    ),
  );
}
