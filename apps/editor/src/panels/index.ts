import type { ComponentType } from 'react';
import { HierarchyPanel } from './hierarchy/HierarchyPanel';
import { InspectorPanel } from './inspector/InspectorPanel';
import { ViewportPanel } from './viewport/ViewportPanel';

/** A part of the editor's window. */
export interface Panel {
  readonly id: string;
  readonly title: string;
  readonly place: 'left' | 'middle' | 'right';
  readonly component: ComponentType;
}

/** All panels. A new one is a folder and a line here. */
export const panels: readonly Panel[] = [
  { id: 'hierarchy', title: 'Hierarchy', place: 'left', component: HierarchyPanel },
  { id: 'viewport', title: 'Viewport', place: 'middle', component: ViewportPanel },
  { id: 'inspector', title: 'Inspector', place: 'right', component: InspectorPanel },
];
