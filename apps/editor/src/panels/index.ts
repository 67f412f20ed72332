import type { Panel } from '../layout/PanelRegistry';

/** All built-in panels, each fetched when first in front. A new panel is a folder and a line here. */
export const panels: readonly Panel[] = [
  {
    id: 'hierarchy',
    title: 'Hierarchy',
    icon: 'tree',
    place: 'left',
    load: () => import('./hierarchy/HierarchyPanel').then(({ HierarchyPanel }) => HierarchyPanel),
  },
  {
    id: 'viewport',
    title: 'Viewport',
    icon: 'camera',
    place: 'middle',
    load: () => import('./viewport/ViewportPanel').then(({ ViewportPanel }) => ViewportPanel),
  },
  {
    id: 'inspector',
    title: 'Inspector',
    icon: 'sliders',
    place: 'right',
    load: () => import('./inspector/InspectorPanel').then(({ InspectorPanel }) => InspectorPanel),
  },
  {
    id: 'history',
    title: 'History',
    icon: 'undo',
    place: 'right',
    load: () => import('./history/HistoryPanel').then(({ HistoryPanel }) => HistoryPanel),
  },
  {
    id: 'assets',
    title: 'Assets',
    icon: 'assets',
    place: 'bottom',
    load: () => import('./assets/AssetsPanel').then(({ AssetsPanel }) => AssetsPanel),
  },
  {
    id: 'frame',
    title: 'Frame',
    icon: 'gauge',
    place: 'right',
    load: () => import('./frame/FramePanel').then(({ FramePanel }) => FramePanel),
  },
  {
    id: 'bake',
    title: 'Baked light',
    icon: 'lamp',
    place: 'right',
    isOpen: false,
    load: () => import('./bake/BakePanel').then(({ BakePanel }) => BakePanel),
  },
  {
    id: 'console',
    title: 'Console',
    icon: 'console',
    place: 'bottom',
    load: () => import('./console/ConsolePanel').then(({ ConsolePanel }) => ConsolePanel),
  },
  {
    id: 'scripts',
    title: 'Scripts',
    icon: 'code',
    place: 'bottom',
    load: () => import('./scripts/ScriptsPanel').then(({ ScriptsPanel }) => ScriptsPanel),
  },
  {
    id: 'microshaders',
    title: 'Microshaders',
    icon: 'code',
    place: 'bottom',
    load: () => import('./microshaders/MicroShadersPanel').then(({ MicroShadersPanel }) => MicroShadersPanel),
  },
  {
    id: 'timeline',
    title: 'Timeline',
    icon: 'timeline',
    place: 'bottom',
    load: () => import('./timeline/TimelinePanel').then(({ TimelinePanel }) => TimelinePanel),
  },
];
