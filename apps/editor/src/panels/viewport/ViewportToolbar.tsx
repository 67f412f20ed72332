import { t } from '@farol/editing';
import { type ReactNode, useSyncExternalStore } from 'react';
import { Camera } from '@farol/engine';
import { gizmoModes, gizmoSpace, snap } from '../../actions/handles';
import {
  continuous,
  quadView,
  showColliders,
  showGrid,
  showIcons,
  showRanges,
  showStatistics,
} from '../../actions/display';
import { actionEntry, type MenuEntry } from '../../api/MenuEntry';
import { ActionButton } from '../../ui/ActionButton';
import { MenuButton } from '../../ui/MenuButton';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { ShadingMenu } from './ShadingMenu';
import { SnapSteps } from './SnapSteps';
import { ViewCube } from './ViewCube';
import { ViewsMenu } from './ViewsMenu';
import type { Viewport } from '../../viewport/Viewport';
import { useIsNarrow } from '../../ui/useIsNarrow';
import { usePreferences } from '../../ui/usePreferences';
import { LateSelectBox as SelectBox } from '../../ui/LateSelectBox';

const EDITOR_CAMERA = '/';

/** Width below which the display buttons are folded into one menu (CSS pixels). */
const FOLDED = 440;

/** Display settings of the viewport. */
const display = [showGrid, showIcons, showRanges, showColliders, continuous, showStatistics, quadView];

/** Shows a camera's view. @param id - id of a Camera of the scene; any other text for the editor's camera */
function lookThrough(viewport: Viewport, id: string): void {
  viewport.lookThrough = viewport.document.scene.componentsOf(Camera).find((camera) => camera.id === id) ?? null;
}

/** Toolbar over the viewport: gizmo modes at the left, display and camera at the right. */
export function ViewportToolbar(): ReactNode {
  const editor = useEditor();
  const { document, viewport, layout } = editor;
  const [ref, isNarrow] = useIsNarrow(FOLDED);
  const isSmall = useSyncExternalStore(layout.subscribe, layout.isSmall) || isNarrow;
  useSignal(viewport.changed);
  // the toolbar is rendered again when the increments change, since the snapping button's label contains them
  usePreferences(({ snapSteps }) => snapSteps);
  useSignal(document.structure);
  const cameras = document.scene.componentsOf(Camera).map((camera) => ({
    value: camera.id,
    label: camera.gameObject.name,
    help: t('Keys and mouse go to the scene while it plays.'),
  }));
  const through = viewport.lookThrough?.id ?? EDITOR_CAMERA;
  const views = [{ value: EDITOR_CAMERA, label: t("Editor's camera") }, ...cameras];
  const folded = (): MenuEntry[] => [
    ...display.map((action) => actionEntry(action, editor)),
    'separator',
    ...views.map(({ value, label }) => ({
      label,
      checked: value === through,
      run: () => lookThrough(viewport, value),
    })),
  ];
  return (
    <div className="viewport-bar" ref={ref}>
      <div className="button-group handles" role="toolbar" aria-label={t('Handles')}>
        {gizmoModes.map((action) => (
          <ActionButton key={action.id} action={action} />
        ))}
        <span className="bar-line" />
        <ActionButton action={gizmoSpace} icon={viewport.space === 'local' ? 'local' : 'world'} />
        <ActionButton action={snap} />
        <SnapSteps />
      </div>
      {isSmall ? (
        <div className="button-group">
          <ViewsMenu />
          <ShadingMenu />
          <MenuButton label={t('Display')} icon="eye" iconOnly entries={folded} />
        </div>
      ) : (
        <div className="button-group" role="toolbar" aria-label={t('Display')}>
          {display.map((action) => (
            <ActionButton key={action.id} action={action} />
          ))}
          <span className="bar-line" />
          <ViewsMenu />
          <ShadingMenu />
          <SelectBox
            value={through}
            options={views}
            label={t('Look through')}
            onChange={(id) => lookThrough(viewport, id)}
          />
        </div>
      )}
      {viewport.lookThrough === null && <ViewCube />}
    </div>
  );
}
