import { Menu } from '@base-ui/react/menu';
import { t } from '@farol/editing';
import { type ReactNode, useEffect, useState } from 'react';
import { setShading, shadings } from '../../actions/display';
import { actionEntry, type MenuEntry } from '../../api/MenuEntry';
import type { EditorApi } from '../../api/EditorApi';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { LateItems } from '../../ui/MenuButton';
import { techniqueOptions } from '../../ui/techniqueOptions';
import { viewOptions } from '../../ui/viewOptions';
import type { Shading } from '../../viewport/shading/Shading';

function entriesOf(editor: EditorApi): readonly MenuEntry[] {
  const { viewport } = editor;
  const line = (label: string, shading: Shading, help?: string): MenuEntry => ({
    label,
    help,
    checked: viewport.shading === shading,
    run: () => editor.attempt(() => setShading(editor, shading)),
  });
  const withoutTechniques = shadings.map((action) => actionEntry(action, editor));
  const techniques = techniqueOptions(viewport.farol)
    .filter(({ value }) => value !== 'auto')
    .map(({ value, label, help }) => line(label, `by:${value}`, help));
  const views = viewOptions().map(({ value, label }) => line(label, `view:${value}`));
  return [...withoutTechniques, { label: t('Debug view'), entries: views }, 'separator', ...techniques];
}

/** Menu of the active view's shading: without lights, the scene's technique, or another one. */
export function ShadingMenu(): ReactNode {
  const editor = useEditor();
  const { viewport } = editor;
  const [isOpen, setIsOpen] = useState(false);
  useEffect(() => viewport.shadingAsked.subscribe(() => setIsOpen(true)), [viewport]);
  const label = t('Shading');
  return (
    <Menu.Root open={isOpen} onOpenChange={setIsOpen}>
      <Menu.Trigger
        className="button"
        aria-label={label}
        title={label}
        disabled={viewport.painter !== null}
        data-changed={viewport.shading === 'scene' ? undefined : ''}
      >
        <Icon name="shading" />
        <Icon name="down" size={10} />
      </Menu.Trigger>
      <Menu.Portal>
        <Menu.Positioner className="positioner" sideOffset={3} align="end">
          <Menu.Popup className="popup" finalFocus={() => viewport.canvas}>
            <LateItems entries={() => entriesOf(editor)} />
          </Menu.Popup>
        </Menu.Positioner>
      </Menu.Portal>
    </Menu.Root>
  );
}
