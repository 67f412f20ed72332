import { t } from '@farol/editing';
import { type ReactNode, useState } from 'react';
import { Icon } from '../../ui/Icon';
import { useFold } from './Section';

interface FieldGroupProps {
  /** Key under which the folded state is stored. */
  readonly id: string;
  readonly title: string;
  /** Whether the group is folded by default; called once, so that edits never fold it. */
  readonly isFoldedAtFirst: () => boolean;
  readonly children: ReactNode;
}

/** A foldable group of fields in a section; its state is remembered. */
export function FieldGroup({ id, title, isFoldedAtFirst, children }: FieldGroupProps): ReactNode {
  const [first] = useState(isFoldedAtFirst);
  const [isFolded, fold] = useFold(id, first);
  return (
    <div className="field-group" role="group" aria-label={t(title)}>
      <button type="button" className="field-group-title" aria-expanded={!isFolded} onClick={fold}>
        <span className="fold" data-open={!isFolded}>
          <Icon name="chevron" size={9} />
        </span>
        {t(title)}
      </button>
      {!isFolded && children}
    </div>
  );
}
