import { keepViews, showViews } from './bookmarks';
import { align, distribute, drop } from './arrange';
import { cameraActions } from './cameras';
import { copy, cut, paste, pasteBelow } from './clipboard';
import type { Action } from '../api/Action';
import { bakeLight, toggleStatic } from './bake';
import { duplicate } from './duplicate';
import { duplicateMany } from './duplicateMany';
import { focus } from './focus';
import { gizmoModes } from './gizmoModes';
import { gizmoSpace } from './gizmoSpace';
import { group, ungroup } from './group';
import { about, guides } from './guides';
import { hide } from './hide';
import { chooseLanguage } from './language';
import { lock } from './lock';
import { measureDistance } from './measureDistance';
import { newScene, openExamples } from './newScene';
import { open } from './open';
import { muteSound, pause, play, playFromCamera, playFromHere, step, stop } from './play';
import { makeMaterial, newMaterial, newScript, unpackModel } from './materials';
import { physicsActions } from './physics';
import { makePrefab, unpackPrefab } from './prefabs';
import { recover } from './recover';
import { toggleOrthographic, turns } from './projection';
import { nextView, quadView, resetViews } from './quadView';
import { redo } from './redo';
import { remove } from './remove';
import { rename } from './rename';
import { save, saveAs } from './save';
import { exportScene, measure } from './share';
import { newSurfaces } from './surfaces';
import { deselect, selectAll } from './selectAll';
import { shadings, showShadings } from './shadings';
import { showKeys } from './showKeys';
import { showPalette } from './showPalette';
import { goToMenuBar, maximiseViewport, nextPanel, previousPanel, resetPanels } from './showPanels';
import { lookFrom } from './sides';
import { snap } from './snap';
import { alignToSurface, gizmoPivots, snapTargets } from './snapping';
import { themes } from './themes';
import { addKeys, record } from './timeline';
import { undo } from './undo';
import { startTour, welcome } from './welcome';
import {
  continuous,
  showColliders,
  showGrid,
  showIcons,
  showPictureEffects,
  showRanges,
  showStatistics,
} from './viewportToggles';

/** All built-in actions. A new action is a file and a line here. */
export const actions: readonly Action[] = [
  welcome,
  newScene,
  ...openExamples,
  open,
  save,
  saveAs,
  exportScene,
  measure,
  recover,
  undo,
  redo,
  cut,
  copy,
  paste,
  pasteBelow,
  duplicate,
  duplicateMany,
  drop,
  ...align,
  ...distribute,
  measureDistance,
  group,
  ungroup,
  remove,
  rename,
  hide,
  lock,
  toggleStatic,
  selectAll,
  deselect,
  makePrefab,
  unpackPrefab,
  newMaterial,
  makeMaterial,
  ...newSurfaces,
  unpackModel,
  newScript,
  ...physicsActions,
  bakeLight,
  ...gizmoModes,
  gizmoSpace,
  snap,
  ...snapTargets,
  alignToSurface,
  ...gizmoPivots,
  focus,
  showGrid,
  showPictureEffects,
  showIcons,
  showRanges,
  showColliders,
  continuous,
  showStatistics,
  ...lookFrom,
  toggleOrthographic,
  ...turns,
  ...cameraActions,
  ...showViews,
  ...keepViews,
  quadView,
  nextView,
  resetViews,
  ...shadings,
  showShadings,
  play,
  playFromCamera,
  playFromHere,
  muteSound,
  pause,
  step,
  stop,
  record,
  addKeys,
  maximiseViewport,
  resetPanels,
  goToMenuBar,
  nextPanel,
  previousPanel,
  ...themes,
  showPalette,
  showKeys,
  startTour,
  ...guides,
  ...chooseLanguage,
  about,
];
