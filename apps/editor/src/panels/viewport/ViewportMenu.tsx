import { Menu } from '@base-ui/react/menu';
import { t } from '@farol/editing';
import { type ReactNode, useEffect, useMemo, useState } from 'react';
import { addEntries } from '../../actions/addEntries';
import { paste, pasteAt } from '../../actions/clipboard';
import { objectEntries } from '../../actions/objectEntries';
import { useEditor } from '../../ui/EditorContext';
import { LateItems } from '../../ui/MenuButton';
import type { MenuEntry } from '../../api/MenuEntry';
import { MenuPress } from '../../viewport/MenuPress';

/** Context menu of the object under the pointer, or else the Add menu. */
export function ViewportMenu(): ReactNode {
  const editor = useEditor();
  const { viewport } = editor;
  const [isOpen, setIsOpen] = useState(false);
  const [point, setPoint] = useState({ x: 0, y: 0 });
  useEffect(() => {
    const press = new MenuPress(viewport, (x, y) => {
      setPoint({ x, y });
      setIsOpen(true);
    });
    return () => press.dispose();
  }, [viewport]);
  const anchor = useMemo(() => ({ getBoundingClientRect: () => DOMRect.fromRect(point) }), [point]);
  const pasteEntry = (): MenuEntry => ({
    label: t('Paste here'),
    icon: paste.icon,
    disabled: !paste.enabled!(editor),
    run: () => editor.attempt(() => pasteAt(editor, point)),
  });
  const entries = (): readonly MenuEntry[] =>
    objectEntries(editor) ?? [...addEntries(editor, null, point), 'separator', pasteEntry()];
  return (
    <Menu.Root open={isOpen} onOpenChange={setIsOpen}>
      <Menu.Portal>
        <Menu.Positioner className="positioner" anchor={anchor} side="right" align="start" sideOffset={2}>
          <Menu.Popup className="popup" finalFocus={() => viewport.canvas}>
            <LateItems entries={entries} />
          </Menu.Popup>
        </Menu.Positioner>
      </Menu.Portal>
    </Menu.Root>
  );
}
