import { t } from '@farol/editing';
import type { SceneSettings } from '@farol/engine';
import { type ReactNode, useMemo } from 'react';
import { FieldList } from './FieldList';
import { Section } from './Section';

const names = ['gravity'];

export function PhysicsSection({ settings }: { settings: SceneSettings }): ReactNode {
  const owners = useMemo(() => [settings], [settings]);
  return (
    <Section id="Physics" title={t('Physics')} help={t('How bodies move while the scene plays.')} icon="body">
      <FieldList owners={owners} names={names} />
    </Section>
  );
}
