import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { Icon } from '../../ui/Icon';

/** Name and state of the script. */
export function ScriptBar({ name, isBroken }: { name: string; isBroken: boolean }): ReactNode {
  return (
    <div className="panel-bar">
      <strong>{name}</strong>
      <span className={isBroken ? 'chunk-state broken' : 'chunk-state'} role="status">
        {isBroken && <Icon name="warning" size={12} />}
        {isBroken ? t('Cannot be read yet: the last good text runs') : ''}
      </span>
    </div>
  );
}
