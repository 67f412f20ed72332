export { machineSlowness } from '@farol/tools/machineSlowness';
