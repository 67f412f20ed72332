import type { ReactNode } from 'react';
import { type Action, labelOf } from '../api/Action';
import { useEditor } from './EditorContext';
import { Icon } from './Icon';
import type { IconName } from '../style/iconPaths';
import { keyText } from './keyText';
import { useKeyBindings } from './useKeyBindings';

interface ActionButtonProps {
  readonly action: Action;
  /** Replaces the action's own icon. */
  readonly icon?: IconName;
  /** Whether the label is shown beside the icon. */
  readonly withLabel?: boolean;
}

/** A button for an action, pressed while the action is on. The parent must render again when the action changes. */
export function ActionButton({ action, icon = action.icon, withLabel = false }: ActionButtonProps): ReactNode {
  const editor = useEditor();
  const label = labelOf(action, editor);
  const key = useKeyBindings().keysOf(action).at(0);
  return (
    <button
      type="button"
      className="button"
      title={key ? `${label} (${keyText(key)})` : label}
      aria-label={withLabel ? undefined : label}
      aria-keyshortcuts={key?.replace('Ctrl', 'Control')}
      aria-pressed={action.checked?.(editor)}
      disabled={!(action.enabled?.(editor) ?? true)}
      onClick={() => editor.attempt(() => action.run(editor))}
    >
      {icon && <Icon name={icon} />}
      {withLabel && <span>{label}</span>}
    </button>
  );
}
