import type { Action, MenuPlace } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import { align, distribute, drop } from './arrange';
import { keepViews, showViews } from './bookmarks';
import { cameraActions } from './cameras';
import { copy, cut, paste, pasteBelow } from './clipboard';
import {
  continuous,
  explainPixel,
  measureDistance,
  measureLight,
  showIlluminance,
  nextView,
  quadView,
  resetViews,
  shadings,
  showColliders,
  showGrid,
  showIcons,
  showPictureEffects,
  showRanges,
  showShadings,
  showStatistics,
  techniqueActions,
  viewActions,
} from './display';
import { deselect, duplicate, redo, remove, selectAll, undo } from './edit';
import {
  choosePicture,
  exportScene,
  letAgentEdit,
  measure,
  newScene,
  open,
  openExamples,
  openOnPhone,
  saveFilm,
  savePicture,
  recentActions,
  recover,
  save,
  saveAs,
  welcome,
} from './file';
import { alignToSurface, gizmoModes, gizmoPivots, gizmoSpace, snap, snapTargets } from './handles';
import { about, chooseLanguage, guides, otherApps, showKeys, showPalette, startTour } from './help';
import { makeMaterial, newMaterial, newScript, newSurfaces, unpackModel } from './materials';
import {
  bakeLight,
  duplicateMany,
  group,
  hide,
  lock,
  makePrefab,
  physicsActions,
  rename,
  toggleStatic,
  ungroup,
  unpackPrefab,
} from './object';
import {
  goToMenuBar,
  maximisePanel,
  maximiseViewport,
  nextPanel,
  previousPanel,
  resetPanels,
  showPanels,
  themes,
} from './panels';
import { focus, lookFrom, toggleOrthographic, turns } from './viewpoint';
import { muteSound, pause, play, playFromCamera, playFromHere, step, stop } from './play';
import { addKeys, record } from './timeline';

/** Actions of a menu's groups, some of them in submenus. Separators are drawn between groups. */
type MenuGroups = Readonly<
  Record<string, readonly (Action | { readonly submenu: string; readonly actions: readonly Action[] })[]>
>;

/**
 * The menu bar. Empty groups are filled by generated actions and by plugins' actions; groups that only plugins name
 * come last.
 */
export const menuBar: Readonly<Record<MenuPlace['menu'], MenuGroups>> = {
  file: {
    new: [welcome, newScene, { submenu: 'Samples', actions: openExamples }],
    open: [open],
    save: [save, saveAs],
    share: [exportScene, savePicture, saveFilm, choosePicture, openOnPhone, letAgentEdit, measure],
    recover: [recover],
  },
  edit: {
    history: [undo, redo],
    clipboard: [cut, copy, paste, pasteBelow, duplicate, remove],
    select: [selectAll, deselect],
    handles: [
      { submenu: 'Handles', actions: [...gizmoModes, gizmoSpace, snap] },
      { submenu: 'Snapping', actions: [...snapTargets, alignToSurface] },
      { submenu: 'Pivot', actions: gizmoPivots },
    ],
    play: [play, playFromCamera, playFromHere, muteSound, pause, step, stop],
    animation: [record, addKeys],
    plugins: [],
  },
  object: {
    name: [rename],
    state: [hide, lock, toggleStatic],
    tree: [group, ungroup],
    duplicate: [duplicateMany],
    align: [drop, { submenu: 'Align', actions: align }, { submenu: 'Distribute', actions: distribute }],
    material: [newMaterial, makeMaterial, { submenu: 'New surface', actions: newSurfaces }, unpackModel, newScript],
    physics: [{ submenu: 'Physics', actions: physicsActions }],
    prefab: [makePrefab, unpackPrefab],
    light: [bakeLight],
  },
  view: {
    camera: [focus, ...cameraActions],
    side: [
      { submenu: 'Look from', actions: lookFrom },
      toggleOrthographic,
      { submenu: 'Turn the view', actions: turns },
    ],
    bookmarks: [
      { submenu: 'Saved views', actions: showViews },
      { submenu: 'Keep this view', actions: keepViews },
    ],
    views: [quadView, nextView, resetViews],
    shading: [{ submenu: 'Shading', actions: [...shadings, showShadings] }],
    picture: [],
    show: [showGrid, showPictureEffects, showIcons, showRanges, showColliders],
    measure: [measureDistance, measureLight, explainPixel, showIlluminance],
    figures: [continuous, showStatistics],
    panels: [maximiseViewport, maximisePanel, resetPanels],
    window: [
      { submenu: 'Go to', actions: [goToMenuBar, nextPanel, previousPanel] },
      { submenu: 'Theme', actions: themes },
    ],
  },
  help: {
    keys: [showPalette, showKeys],
    learn: [startTour, { submenu: 'Guides and examples', actions: guides }],
    language: [{ submenu: 'Language', actions: chooseLanguage }],
    apps: otherApps,
    about: [about],
  },
};

const placed = (actions: readonly Action[], menu: MenuPlace): Action[] =>
  actions.map((action) => ({ ...action, menu }));

/** The built-in actions, each with its place in the menu bar. */
export const actions: readonly Action[] = (Object.keys(menuBar) as MenuPlace['menu'][]).flatMap((menu) =>
  Object.entries(menuBar[menu]).flatMap(([group, parts]) =>
    parts.flatMap((part) =>
      'submenu' in part
        ? placed(part.actions, { menu, group, submenu: part.submenu })
        : placed([part], { menu, group }),
    ),
  ),
);

/** The actions of the registry, and those generated for each recent file, technique, view and panel. */
export const allActions = (editor: EditorApi): Action[] => [
  ...editor.actions.list,
  ...placed(recentActions(editor), { menu: 'file', group: 'open', submenu: 'Recent files' }),
  ...placed(techniqueActions(editor), { menu: 'view', group: 'picture', submenu: 'Technique' }),
  ...placed(viewActions, { menu: 'view', group: 'picture', submenu: 'Show' }),
  ...placed(showPanels(editor), { menu: 'view', group: 'panels', submenu: 'Panels' }),
];
