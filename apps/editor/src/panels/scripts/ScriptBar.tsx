import { t, tCount } from '@farol/editing';
import type { ReactNode } from 'react';
import { Icon } from '../../ui/Icon';

interface ScriptBarProps {
  readonly name: string;
  /** Whether the script has a syntax error. */
  readonly isBroken: boolean;
  /** Number of errors and warnings. */
  readonly problems: number;
  /** Whether TypeScript's language service is ready. */
  readonly isReady: boolean;
  /** Why the language service is unavailable; null when it is available. */
  readonly failure: string | null;
}

function stateOf({ isBroken, problems, isReady, failure }: ScriptBarProps): string {
  if (isBroken) return t('Syntax error: the last valid text runs');
  if (problems > 0) return tCount(problems, '{count} error', '{count} errors');
  if (failure !== null) return t('No completion: {reason}', { reason: failure });
  return isReady ? '' : t('Completion is loading…');
}

export function ScriptBar(props: ScriptBarProps): ReactNode {
  const { name, isBroken, problems } = props;
  const isWrong = isBroken || problems > 0;
  return (
    <div className="panel-bar">
      <strong>{name}</strong>
      <span className={isWrong ? 'chunk-state broken' : 'chunk-state'} role="status">
        {isWrong && <Icon name="warning" size={12} />}
        {stateOf(props)}
      </span>
    </div>
  );
}
