import { Signal, t, tCount } from '@farol/editing';
import type { ReactNode } from 'react';
import { linkOf, linksChanged } from '../../agent/AgentLink';
import { Button } from '../../ui/Button';
import { useEditor, useSignal } from '../../ui/EditorContext';
import './agent.css';

/** Signal that never emits, in place of `AgentLink.changed` while no agent is allowed. */
const never = new Signal();

/** Bar at the top of the window while agents may edit: their names, number of calls, and a button to end the link. */
export function AgentBar(): ReactNode {
  useSignal(linksChanged);
  const link = linkOf(useEditor());
  useSignal(link?.changed ?? never);
  if (!link) return null;
  const names = [...new Set(link.clients)].join(', ');
  return (
    <aside className="agent-bar" aria-label={t('An agent may edit')}>
      <span className="agent-dot" aria-hidden="true" />
      <span className="agent-names one-line" role="status">
        {names ? t('{names} may edit', { names }) : t('An agent may edit')}
      </span>
      <span className="agent-calls">
        {names ? tCount(link.count, '{count} call', '{count} calls') : t('none is connected yet')}
      </span>
      <Button label={t('End it')} onClick={() => link.end()} />
    </aside>
  );
}
