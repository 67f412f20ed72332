export { FarolInComposer } from './FarolInComposer';
export type { FarolProps } from '../r3f/useFarolSettings';
