export { FarolPostPass } from './FarolPostPass';
