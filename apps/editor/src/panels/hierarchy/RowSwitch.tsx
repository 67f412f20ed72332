import type { ReactNode } from 'react';
import { IconButton } from '../../ui/IconButton';
import type { IconName } from '../../style/iconPaths';

interface RowSwitchProps {
  readonly name: string;
  readonly isOn: boolean;
  /** Whether an ancestor sets the state. */
  readonly isInherited: boolean;
  /** Label when off, label when on, and the key that toggles. */
  readonly words: readonly [string, string, string];
  readonly icons: readonly [IconName, IconName];
  onChange(isOn: boolean): void;
}

/** A switch at the end of a row. Not reachable by Tab, since the row itself has a key for it. */
export function RowSwitch({ name, isOn, isInherited, words, icons, onChange }: RowSwitchProps): ReactNode {
  const word = words[isOn ? 1 : 0];
  return (
    <IconButton
      icon={icons[isInherited ? 1 : 0]}
      size={14}
      className="row-switch"
      tabIndex={-1}
      label={`${word} ${name}`}
      title={`${word} (${words[2]})`}
      aria-pressed={isOn}
      data-inherited={isInherited}
      onDoubleClick={(event) => event.stopPropagation()}
      onClick={(event) => {
        event.stopPropagation();
        onChange(!isOn);
      }}
    />
  );
}
