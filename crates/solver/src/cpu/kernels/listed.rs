//! Nodes and cells on a list, whose numbers cross to a device and back.

use super::Real;
use super::addresses::{Both, Done, launch};
use super::device_arrays::Arrays;
use crate::device::{Address, Driver, Touched};
use ::kernels::launch::{Kernel, LISTED, List};
use bytemuck::{cast_slice, cast_slice_mut};
use std::ptr::null_mut;

/// Nodes or cells on a list, with room for their numbers on the device.
#[derive(Debug, Default)]
pub(super) struct Listed {
    pub(super) entries: Vec<u32>,
    /// Their indices and numbers on the device.
    on_device: Option<[Address; 2]>,
    /// Nodes or cells, and numbers of each, for which there is room on the device.
    room: [usize; 2],
    values: Vec<Real>,
}

impl Listed {
    /// Other nodes or cells, with room for so many numbers of each.
    pub(super) fn renew(&mut self, entries: Vec<u32>, numbers: usize, driver: &mut dyn Driver) -> Done {
        self.entries = entries;
        let count = self.entries.len();
        if count > self.room[0] || numbers > self.room[1] {
            self.on_device.take().into_iter().flatten().for_each(|address| driver.free(address));
            self.room = [(count + count / 2).max(self.room[0]), numbers.max(self.room[1])];
            let [count, numbers] = self.room;
            let places = driver.allocate(count * size_of::<u32>())?;
            self.on_device = Some([places, driver.allocate(count * numbers * size_of::<Real>())?]);
        }
        match self.on_device {
            Some([places, _]) if count > 0 => driver.write(places, cast_slice(&self.entries)),
            _ => Ok(()),
        }
    }

    /// Addresses of the indices and numbers, if there are any.
    pub(super) fn addresses(&self) -> Option<[Address; 2]> {
        self.on_device.filter(|_| !self.entries.is_empty())
    }

    /// Gives the device the numbers of these arrays.
    pub(super) fn give(&mut self, driver: &mut dyn Driver, arrays: &Arrays, both: &[Both]) -> Done {
        let Some([_, values]) = self.addresses() else { return Ok(()) };
        self.values.clear();
        for (_, array) in both {
            self.values.extend(self.entries.iter().map(|n| array[*n as usize]));
        }
        driver.write(values, cast_slice(&self.values))?;
        launch(driver, Kernel::Give, self.entries.len(), arrays, &self.list(both))
    }

    /// Takes the numbers of these arrays from the device.
    pub(super) fn take(&mut self, driver: &mut dyn Driver, arrays: &Arrays, both: &mut [Both]) -> Done {
        self.begin_taking(driver, arrays, both)?;
        self.end_taking(driver, both)
    }

    /// Begins to take the numbers that the launches so far leave in these arrays.
    pub(super) fn begin_taking(&self, driver: &mut dyn Driver, arrays: &Arrays, both: &[Both]) -> Done {
        let Some([_, values]) = self.addresses() else { return Ok(()) };
        launch(driver, Kernel::Take, self.entries.len(), arrays, &self.list(both))?;
        driver.begin_read(values, both.len() * self.entries.len() * size_of::<Real>())
    }

    /// Ends that.
    pub(super) fn end_taking(&mut self, driver: &mut dyn Driver, both: &mut [Both]) -> Done {
        if self.addresses().is_none() {
            return Ok(());
        }
        self.values.resize(both.len() * self.entries.len(), 0.0);
        driver.end_read(cast_slice_mut(&mut self.values))?;
        for ((_, array), own) in both.iter_mut().zip(self.values.chunks_exact(self.entries.len())) {
            self.entries.iter().zip(own).for_each(|(n, value)| array[*n as usize] = *value);
        }
        Ok(())
    }

    fn list(&self, both: &[Both]) -> List<Real> {
        let [entries, values] = self.on_device.unwrap_or([Address(0); 2]);
        let mut arrays = [null_mut(); LISTED];
        arrays.iter_mut().zip(both).for_each(|(to, (from, _))| *to = from.pointer());
        List {
            count: self.entries.len(),
            entries: entries.pointer::<u32>().cast_const(),
            values: values.pointer(),
            numbers: both.len(),
            arrays,
        }
    }
}

/// Cells and nodes that the processor works on during a remap.
#[derive(Debug, Default)]
pub(super) struct Region {
    pub(super) cells: Listed,
    pub(super) nodes: Listed,
}

impl Region {
    /// Other cells and nodes.
    pub(super) fn renew(&mut self, touched: Touched, driver: &mut dyn Driver) -> Done {
        self.cells.renew(touched.cells, LISTED, driver)?;
        self.nodes.renew(touched.nodes, 4, driver)
    }

    /// Sets the entries of the cells to zero.
    pub(super) fn clear(&self, array: &mut [Real]) {
        self.cells.entries.iter().for_each(|c| array[*c as usize] = 0.0);
    }
}
