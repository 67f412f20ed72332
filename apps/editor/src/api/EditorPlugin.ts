import type { ComponentClass } from '@farol/engine';
import type { CustomField, FieldType } from '@farol/engine/fields';
import type { Technique } from '@farol/renderer';
import type { ComponentType } from 'react';
import type { Action } from './Action';
import type { EditorApi } from './EditorApi';
import type { FieldEditorProps } from './FieldEditorProps';
import type { Panel } from '../layout/PanelRegistry';

/** A kind of field: what it allows, and what it is edited with. Declare fields of it by the engine's `custom`. */
export interface PluginFieldType extends FieldType {
  readonly editor: ComponentType<FieldEditorProps<CustomField>>;
}

/** What a plugin brings; see `addPlugin`. All parts may be left out. */
export interface EditorPlugin {
  /** Named in errors and in the console. */
  readonly name: string;
  readonly panels?: readonly Panel[];
  /** Classes that extend the engine's `component({ … })`: in the menu Add component, the inspector, files and undo. */
  readonly components?: readonly ComponentClass[];
  readonly fieldTypes?: readonly PluginFieldType[];
  /** By key: in every menu of techniques. */
  readonly techniques?: Readonly<Record<string, Technique>>;
  /** Commands: in the palette, on the page of keys, and by their keys. */
  readonly actions?: readonly Action[];
  /** Called last. */
  setUp?(editor: EditorApi): void;
}
