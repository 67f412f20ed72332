import { describe, expect, it } from 'vitest';
import { Forecast } from './Forecast';

describe('Forecast', () => {
  it('takes a first frame that compiles at few lights to compile as long at many', () => {
    const forecast = new Forecast(2000);
    forecast.note('planes', 'deferred', 'first', 4, 400);
    forecast.note('planes', 'deferred', 'frame', 4, 1);
    expect(forecast.refuses('planes', 'deferred', 100)).toBeNull();
    forecast.note('planes', 'deferred', 'first', 100, 420);
    forecast.note('planes', 'deferred', 'frame', 100, 3);
    expect(forecast.refuses('planes', 'deferred', 10_000)).toBeNull();
  });

  it('refuses first frames that grow, once two cases show it', () => {
    const forecast = new Forecast(2000);
    forecast.note('planes', 'stock', 'first', 10, 100);
    forecast.note('planes', 'stock', 'first', 100, 1000);
    expect(forecast.refuses('planes', 'stock', 150)).toBeNull();
    expect(forecast.refuses('planes', 'stock', 1000)).toMatch(/^Left out: its first frame would take about 10 s/);
  });

  it('takes no growth for steeper than the time that each light more has cost so far', () => {
    const forecast = new Forecast(3000);
    forecast.note('planes', 'deferred', 'first', 1, 5);
    forecast.note('planes', 'deferred', 'first', 4, 80);
    expect(forecast.refuses('planes', 'deferred', 25)).toBeNull();
    expect(forecast.refuses('planes', 'deferred', 225)).toContain('about 5.6 s');
  });

  it('refuses frames that grow in proportion, after one case', () => {
    const forecast = new Forecast(2000);
    forecast.note('atrium', 'multipass', 'first', 10, 100);
    forecast.note('atrium', 'multipass', 'frame', 10, 100);
    expect(forecast.refuses('atrium', 'multipass', 210)).toMatch(/^Left out: its first frame would take about 2\.1 s/);
    expect(forecast.refuses('atrium', 'multipass', 100)).toBeNull();
    // times of one series or competitor do not affect another
    expect(forecast.refuses('planes', 'multipass', 10_000)).toBeNull();
    expect(forecast.refuses('atrium', 'deferred', 10_000)).toBeNull();
  });
});
